// All minimal sets of axioms for which a question holds: Reiter's hitting set tree, for justifications.
//
// A node of the tree is a set H of axioms that are taken away. Its label is a minimal set among the remaining axioms.
// The node has a child for each axiom of its label, in which this axiom is taken away, too. A branch ends if the
// question does not hold. Every minimal set is the label of some node (Reiter 1987; Kalyanpur, Parsia, Horridge, Sirin:
// Finding All Justifications of OWL DL Entailments, 2007).
#ifndef GEMINGA_REASONING_EXPLANATION_EXPLANATIONS_HPP
#define GEMINGA_REASONING_EXPLANATION_EXPLANATIONS_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "reasoning/explanation/explain_minimal.hpp"

namespace geminga::explanation {

/// The limits of a search. There may be exponentially many minimal sets.
struct ExplanationLimits {
  std::size_t sets = 10;        ///< the most sets in the result
  std::size_t nodes = 100'000;  ///< of the tree
};

/// Minimal sets, the smallest first, and sets of one size in ascending order.
struct AllSets {
  std::vector<AxiomSet> sets;
  /// True if there are other sets or the search ended at a limit.
  bool may_have_more = false;
};

/// Finds a minimal set among these candidates. Nothing if the question does not hold for all of them.
using FindOne = std::function<std::optional<AxiomSet>(const AxiomSet& candidates)>;
/// True if no more work may be done.
using IsSpent = std::function<bool()>;

/// All minimal subsets of the candidates. After the first set, `is_spent` is asked before each search for another one.
[[nodiscard]] AllSets find_all_minimal(const AxiomSet& candidates, const FindOne& find_one, const IsSpent& is_spent,
                                       const ExplanationLimits& limits);

}  // namespace geminga::explanation

#endif
