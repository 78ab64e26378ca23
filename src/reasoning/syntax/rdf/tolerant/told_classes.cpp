#include "reasoning/syntax/rdf/tolerant/told_classes.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geminga::rdf {
namespace {

using syntax::Word;

constexpr std::size_t max_depth = 8;  ///< of expressions inside one another
/// The members of all lists that are looked at. A list may be a circle, or stand in many places.
constexpr std::size_t max_members = 10'000'000;

class Telling {
 public:
  explicit Telling(const Graph& graph) : graph_(graph), is_declared_(graph.node_count()) {}

  ToldClasses run() {
    for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
      const Triple& triple = graph_.triple(number);
      if (!graph_.is_iri(triple.subject)) continue;
      const std::string_view predicate = graph_.text(triple.predicate);
      if (triple.predicate == node_of(Word::rdf_type)) {
        declare(triple);
      } else if (triple.predicate == node_of(Word::rdfs_sub_class_of) || predicate.ends_with("/daml+oil#subClassOf")) {
        below(triple.subject, triple.object, 0);
      } else if (triple.predicate == node_of(Word::owl_equivalent_class) ||
                 predicate.ends_with("/daml+oil#sameClassAs")) {
        below(triple.subject, triple.object, 0);
        above(triple.subject, triple.object);
      } else if (triple.predicate == node_of(Word::owl_intersection_of)) {
        for (const NodeId member : members(triple.object)) below(triple.subject, member, 1);
      } else if (triple.predicate == node_of(Word::owl_union_of)) {
        above_all(triple.subject, triple.object);
      }
    }
    return std::move(told_);
  }

 private:
  void declare(const Triple& triple) {
    const Word type = word_of(triple.object);
    const bool is_class = type == Word::owl_class || type == Word::rdfs_class || type == Word::owl_deprecated_class ||
                          graph_.text(triple.object).ends_with("/daml+oil#Class");
    const auto at = static_cast<std::size_t>(triple.subject);
    if (!is_class || is_declared_[at]) return;
    is_declared_[at] = true;
    told_.declared.push_back(triple.subject);
  }

  void below(NodeId sub, NodeId super, std::size_t depth) {
    if (graph_.is_iri(super)) {
      told_.inclusions.emplace_back(sub, super);
    } else if (graph_.is_blank(super) && depth < max_depth) {
      for (const std::uint32_t number : graph_.about(super, Word::owl_intersection_of)) {
        for (const NodeId member : members(graph_.triple(number).object)) below(sub, member, depth + 1);
      }
    }
  }

  void above(NodeId super, NodeId sub) {
    if (graph_.is_iri(sub)) {
      told_.inclusions.emplace_back(sub, super);
    } else if (graph_.is_blank(sub)) {
      for (const std::uint32_t number : graph_.about(sub, Word::owl_union_of))
        above_all(super, graph_.triple(number).object);
    }
  }

  void above_all(NodeId super, NodeId list) {
    for (const NodeId member : members(list)) {
      if (graph_.is_iri(member)) told_.inclusions.emplace_back(member, super);
    }
  }

  [[nodiscard]] std::vector<NodeId> members(NodeId list) {
    std::vector<NodeId> found;
    while (list != node_of(Word::rdf_nil) && seen_members_++ < max_members) {
      const auto first = graph_.about(list, Word::rdf_first);
      const auto rest = graph_.about(list, Word::rdf_rest);
      if (first.empty()) break;
      found.push_back(graph_.triple(first.front()).object);
      if (rest.empty()) break;
      list = graph_.triple(rest.front()).object;
    }
    return found;
  }

  const Graph& graph_;
  std::vector<bool> is_declared_;
  std::size_t seen_members_ = 0;
  ToldClasses told_;
};

}  // namespace

ToldClasses told_classes(const Graph& graph) { return Telling(graph).run(); }

}  // namespace geminga::rdf
