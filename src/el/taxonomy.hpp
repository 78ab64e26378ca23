// From saturated contexts to the taxonomy: nodes of equivalents, and the direct parents of each.
#ifndef GEMINGA_EL_TAXONOMY_HPP
#define GEMINGA_EL_TAXONOMY_HPP

#include <span>
#include <utility>
#include <vector>

#include "el/classify.hpp"
#include "el/index.hpp"

namespace geminga::el {

/// The subsumptions of atoms that are known, as a graph whose ways up are all that hold. Nodes are representatives.
class SubsumptionGraph {
 public:
  explicit SubsumptionGraph(const Index& index) : index_(index), is_unsatisfiable_(index.size(), false) {}

  void add_edge(ExprId sub, ExprId super) { edges_.emplace_back(number(sub), number(super)); }
  void set_unsatisfiable(ExprId atom) { is_unsatisfiable_[number(atom)] = true; }

  /// Fills representative, parents and is_consistent of a classification whose classes are set. `exprs[c]` is the
  /// representative of class c.
  void reduce(std::span<const ExprId> exprs, Classification& classification) &&;

 private:
  void add_told_edges();
  void close_top();
  void find_nodes(std::span<const ExprId> exprs, Classification& classification);
  void find_candidates(std::span<const ExprId> exprs, const Classification& classification);

  const Index& index_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_;
  std::vector<bool> is_unsatisfiable_;    ///< by atom
  std::vector<std::uint32_t> component_;  ///< by atom
  std::uint32_t component_count_ = 0;
  std::vector<std::uint32_t> class_of_component_;                    ///< the representative class, or none
  std::vector<std::pair<std::uint32_t, std::uint32_t>> candidates_;  ///< class, class right above or higher
};

}  // namespace geminga::el

#endif
