// The graph of subsumptions, which becomes the taxonomy: nodes of equivalents, and the direct parents of each.
#ifndef GEMINGA_REASONING_EL_SUBSUMPTION_GRAPH_HPP
#define GEMINGA_REASONING_EL_SUBSUMPTION_GRAPH_HPP

#include <span>

#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/taxonomy/classification.hpp"
#include "reasoning/taxonomy/reduction.hpp"

namespace geminga::el {

/// A graph of atoms in which a way up stands for each known subsumption. Nodes are representatives.
class SubsumptionGraph {
 public:
  explicit SubsumptionGraph(const IndexedOntology& index) : index_(index) {
    graph_.is_empty.assign(index.size(), false);
  }

  void add_edge(ExprId sub, ExprId super) { graph_.edges.emplace_back(number(sub), number(super)); }
  /// Adds nodes that stand for no expression; their numbers follow those of the index.
  void add_nodes(std::size_t count) { graph_.is_empty.resize(index_.size() + count, false); }
  void set_unsatisfiable(ExprId atom) { graph_.is_empty[number(atom)] = true; }

  /// Fills representative, parents and is_consistent of a classification. Requires that its classes are set, and that
  /// `exprs[c]` is the representative of class c.
  void reduce(std::span<const ExprId> exprs, taxonomy::Classification& classification) &&;

 private:
  void add_told_edges();

  const IndexedOntology& index_;
  taxonomy::Inclusions graph_;
};

}  // namespace geminga::el

#endif
