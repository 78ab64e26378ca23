// All minimal sets of axioms for which something holds: Reiter's hitting set tree, for justifications.
//
// A node of the tree is a set H of axioms that are taken away. Its label is a minimal set among the remaining axioms.
// Something that holds can be broken only by taking away an axiom of that label, so the node has a child for each of
// them. A branch ends if it does not hold any more. Every minimal set is the label of some node (Reiter 1987;
// Kalyanpur, Parsia, Horridge, Sirin: Finding All Justifications of OWL DL Entailments, 2007).
#ifndef GEMINGA_REASONING_EXPLANATION_EXPLANATIONS_HPP
#define GEMINGA_REASONING_EXPLANATION_EXPLANATIONS_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "reasoning/explanation/explain_minimal.hpp"

namespace geminga::explanation {

/// How far to search. There may be exponentially many minimal sets.
struct ExplanationLimits {
  std::size_t sets = 10;        ///< as many are given at most
  std::size_t nodes = 100'000;  ///< of the tree
};

/// Minimal sets, the smallest first, and sets of one size in ascending order.
struct AllSets {
  std::vector<AxiomSet> sets;
  /// Whether there are other sets, or the search ended at a limit. False: there are no others.
  bool may_have_more = false;
};

/// A minimal set among these candidates. Nothing if it does not hold for all of them.
using FindOne = std::function<std::optional<AxiomSet>(const AxiomSet& candidates)>;
/// Whether no more work may be done.
using IsSpent = std::function<bool()>;

/// All minimal subsets of the candidates. `is_spent` is asked before each search for another one, and counts once there
/// is one set.
[[nodiscard]] AllSets find_all_minimal(const AxiomSet& candidates, const FindOne& find_one, const IsSpent& is_spent,
                                       const ExplanationLimits& limits);

}  // namespace geminga::explanation

#endif
