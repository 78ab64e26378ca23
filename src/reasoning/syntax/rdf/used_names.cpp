// Finds the wanted nodes first, then their places by one pass over the triples.
#include "reasoning/syntax/rdf/used_names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "reasoning/syntax/rdf/reserved_words.hpp"

namespace geminga::rdf {
namespace {

constexpr auto word_count = static_cast<std::uint32_t>(syntax::Word::count);

/// The first place of each wanted node among those that `nodes_of` returns for a triple.
template <typename NodesOf>
std::vector<UsedName> places(const Graph& graph, std::vector<bool> is_wanted, NodesOf&& nodes_of) {
  std::vector<UsedName> names;
  auto left = static_cast<std::size_t>(std::ranges::count(is_wanted, true));
  for (std::uint32_t number = 0; number < graph.triple_count() && left > 0 && names.size() < max_used_names; ++number) {
    const Triple& triple = graph.triple(number);
    for (const NodeId node : nodes_of(triple)) {
      if (!is_wanted[static_cast<std::size_t>(node)] || names.size() == max_used_names) continue;
      is_wanted[static_cast<std::size_t>(node)] = false;
      --left;
      names.push_back({std::string(graph.text(node)), graph.file_of(number), triple.line});
    }
  }
  return names;
}

}  // namespace

std::vector<UsedName> unknown_words(const Graph& graph) {
  std::vector<bool> is_unknown(graph.node_count(), false);
  for (std::uint32_t number = word_count; number < graph.node_count(); ++number) {
    const NodeId node{number};
    is_unknown[number] = graph.is_iri(node) && is_reserved(graph.text(node)) && !is_reserved_word(graph.text(node));
  }
  return places(graph, std::move(is_unknown), [](const Triple& triple) {
    return std::array<NodeId, 3>{triple.subject, triple.predicate, triple.object};
  });
}

std::vector<UsedName> undeclared_predicates(const Graph& graph) {
  std::vector<bool> is_undeclared(graph.node_count(), false);
  for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
    const NodeId predicate = graph.triple(number).predicate;
    is_undeclared[static_cast<std::size_t>(predicate)] = static_cast<std::uint32_t>(predicate) >= word_count;
  }
  for (std::uint32_t number = word_count; number < graph.node_count(); ++number) {
    if (!is_undeclared[number]) continue;
    const NodeId node{number};
    if (is_reserved(graph.text(node)) || !graph.about(node, syntax::Word::rdf_type).empty())
      is_undeclared[number] = false;
  }
  return places(graph, std::move(is_undeclared),
                [](const Triple& triple) { return std::array<NodeId, 1>{triple.predicate}; });
}

}  // namespace geminga::rdf
