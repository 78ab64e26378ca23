// The labels of nodes, as a model lists them.
#include "reasoning/dl/hypertableau/written_model.hpp"

#include <algorithm>
#include <vector>

#include "base/sorted.hpp"

namespace geminga::hypertableau {
namespace {

std::vector<clauses::ConceptId> label_of(const Graph& graph, std::size_t concept_count, NodeId node) {
  std::vector<clauses::ConceptId> label;
  for (FactId id = graph.node(node).labels; id != none; id = graph.fact(id).next_a) {
    if (graph.fact(id).predicate < concept_count) label.push_back(clauses::ConceptId{graph.fact(id).predicate});
  }
  std::ranges::sort(label);
  return label;
}

/// Concepts of the node that depend on no choice, and on no other question. A concept that came by an uncertain merge
/// depends on that merge.
std::vector<clauses::ConceptId> certain_label_of(const Graph& graph, std::size_t concept_count, NodeId node,
                                                 DependencySet merged_by, DependencySet supposed) {
  std::vector<clauses::ConceptId> label;
  for (FactId id = graph.node(node).labels; id != none; id = graph.fact(id).next_a) {
    const Fact& fact = graph.fact(id);
    const DependencySet reasons = graph.unite(fact.dependency, merged_by);
    if (fact.predicate < concept_count && (reasons == no_dependency || reasons == supposed))
      label.push_back(clauses::ConceptId{fact.predicate});
  }
  std::ranges::sort(label);
  return label;
}

/// Nodes older than the mark that were put into a concept since.
std::vector<NodeId> find_changed(const Graph& graph, const Mark& before) {
  std::vector<NodeId> changed;
  for (auto id = static_cast<FactId>(before.facts); id < graph.facts().size(); ++id) {
    const Fact& fact = graph.fact(id);
    if (fact.kind == FactKind::concept_of && fact.a < before.nodes) changed.push_back(fact.a);
  }
  base::sort_unique(changed);
  return changed;
}

}  // namespace

Model write_model(const Graph& graph, std::size_t concept_count, NodeId asked, DependencySet supposed,
                  const Mark& before) {
  Model model;
  if (asked != none) {
    DependencySet merged_by = no_dependency;
    asked = graph.current(asked, merged_by);
    model.labels.push_back(label_of(graph, concept_count, asked));
    model.certain = certain_label_of(graph, concept_count, asked, merged_by, supposed);
  }
  const auto write = [&](NodeId node) {
    const NodeKind kind = graph.node(node).kind;
    const bool is_object = kind == NodeKind::root || kind == NodeKind::tree;
    const bool is_blocked = kind == NodeKind::tree && graph.node(node).is_blocked;
    if (node != asked && is_object && graph.is_active(node) && !is_blocked)
      model.labels.push_back(label_of(graph, concept_count, node));
  };
  std::ranges::for_each(find_changed(graph, before), write);
  for (auto node = static_cast<NodeId>(before.nodes); node < graph.node_count(); ++node) write(node);
  return model;
}

}  // namespace geminga::hypertableau
