// Told inclusions are added to those of the closure, and all are reduced.
#include "reasoning/el/subsumption_graph.hpp"

#include <utility>

namespace geminga::el {

void SubsumptionGraph::add_told_edges() {
  for (std::uint32_t id = 0; id < index_.size(); ++id) {
    if (!index_.is_atom(ExprId{id}) || index_.representative(ExprId{id}) != ExprId{id}) continue;
    for (const ExprId above : index_.told_atoms(ExprId{id})) graph_.edges.emplace_back(id, number(above));
    if (index_.is_told_bottom(ExprId{id})) graph_.is_empty[id] = true;
  }
}

void SubsumptionGraph::reduce(std::span<const ExprId> exprs, taxonomy::Classification& classification) && {
  add_told_edges();
  graph_.node_count = static_cast<std::uint32_t>(graph_.is_empty.size());
  graph_.top = number(index_.representative(top_expr));
  graph_.node_of.reserve(exprs.size());
  for (const ExprId expr : exprs) graph_.node_of.push_back(number(expr));
  graph_.top_entity = static_cast<std::uint32_t>(classification.thing);
  graph_.bottom_entity = static_cast<std::uint32_t>(classification.nothing);
  graph_.is_consistent = classification.is_consistent;
  taxonomy::Reduced reduced = taxonomy::reduce(std::move(graph_));
  classification.is_consistent = reduced.is_consistent;
  classification.parent_begin = std::move(reduced.parent_begin);
  classification.representative.reserve(reduced.representative.size());
  for (const std::uint32_t node : reduced.representative)
    classification.representative.push_back(taxonomy::ClassNumber{node});
  classification.parents.reserve(reduced.parents.size());
  for (const std::uint32_t parent : reduced.parents) classification.parents.push_back(taxonomy::ClassNumber{parent});
}

}  // namespace geminga::el
