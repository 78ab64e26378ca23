// Reduces old and new edges together.
#include "reasoning/reasoner/taxonomy.hpp"

#include <algorithm>

#include "base/components.hpp"
#include "base/sorted.hpp"
#include "reasoning/taxonomy/reduction.hpp"

namespace geminga::reasoner {
namespace {

std::uint32_t number(taxonomy::ClassNumber of) { return static_cast<std::uint32_t>(of); }

void reduce(taxonomy::Classification& classification, taxonomy::Inclusions&& graph) {
  const taxonomy::Reduced reduced = taxonomy::reduce(std::move(graph));
  const auto named = [](const std::vector<std::uint32_t>& numbers) {
    std::vector<taxonomy::ClassNumber> result;
    result.reserve(numbers.size());
    for (const std::uint32_t of : numbers) result.push_back(taxonomy::ClassNumber{of});
    return result;
  };
  classification.representative = named(reduced.representative);
  classification.parents = named(reduced.parents);
  classification.parent_begin = reduced.parent_begin;
  classification.is_consistent = reduced.is_consistent;
}

/// The taxonomy as a graph with a node for each class.
taxonomy::Inclusions graph_of(const taxonomy::Classification& classification) {
  const auto count = static_cast<std::uint32_t>(classification.class_count());
  taxonomy::Inclusions graph;
  graph.node_count = count;
  graph.is_empty.assign(count, false);
  graph.is_empty[number(classification.nothing)] = true;
  graph.top = graph.top_entity = number(classification.thing);
  graph.bottom_entity = number(classification.nothing);
  graph.is_consistent = classification.is_consistent;
  for (std::uint32_t at = 0; at < count; ++at) {
    graph.node_of.push_back(at);
    const std::uint32_t representative = number(classification.representative[at]);
    if (representative != at) {
      graph.edges.emplace_back(at, representative);
      graph.edges.emplace_back(representative, at);
    }
    for (const taxonomy::ClassNumber parent : classification.parents_of(taxonomy::ClassNumber{at}))
      graph.edges.emplace_back(at, number(parent));
  }
  return graph;
}

}  // namespace

void extend(taxonomy::Classification& classification, const Subsumptions& more) {
  if (more.empty()) return;
  taxonomy::Inclusions graph = graph_of(classification);
  graph.edges.insert(graph.edges.end(), more.begin(), more.end());
  reduce(classification, std::move(graph));
}

void contradict(taxonomy::Classification& classification, const owl::Ontology& source) {
  taxonomy::Inclusions graph = graph_of(classification);
  graph.is_consistent = false;
  reduce(classification, std::move(graph));
  classification.object_properties = taxonomy::classify_properties(source, taxonomy::PropertyKind::object, false);
  classification.data_properties = taxonomy::classify_properties(source, taxonomy::PropertyKind::data, false);
}

std::vector<std::vector<std::uint32_t>> find_ancestors(const taxonomy::Classification& classification) {
  const auto count = static_cast<std::uint32_t>(classification.class_count());
  const std::uint32_t top = number(classification.representative[number(classification.thing)]);
  // There are no cycles, so each component is one class, and superclasses come first.
  const base::Components components = base::find_components(
      count, [&](std::uint32_t at) { return classification.parents_of(taxonomy::ClassNumber{at}); });
  std::vector<std::uint32_t> order(count);
  for (std::uint32_t at = 0; at < count; ++at) order[components.component[at]] = at;
  std::vector<std::vector<std::uint32_t>> ancestors(count);
  for (const std::uint32_t at : order) {
    std::vector<std::uint32_t>& own = ancestors[at];
    for (const taxonomy::ClassNumber parent : classification.parents_of(taxonomy::ClassNumber{at})) {
      if (number(parent) == top) continue;
      own.push_back(number(parent));
      const auto& above = ancestors[number(parent)];
      own.insert(own.end(), above.begin(), above.end());
    }
    base::sort_unique(own);
  }
  return ancestors;
}

}  // namespace geminga::reasoner
