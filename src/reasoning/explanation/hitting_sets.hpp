// Minimal hitting sets: the least sets of axioms that have one of each given set.
//
// If the given sets are all minimal sets that entail something, taking out a hitting set is a least way to undo it
// (Reiter: A Theory of Diagnosis from First Principles, 1987).
#ifndef GEMINGA_REASONING_EXPLANATION_HITTING_SETS_HPP
#define GEMINGA_REASONING_EXPLANATION_HITTING_SETS_HPP

#include <cstddef>
#include <vector>

#include "reasoning/explanation/explanations.hpp"

namespace geminga::explanation {

/// The sets in groups: sets that share an axiom, directly or through others, are of one group. Each group keeps their
/// order, and groups stand in the order of their first sets.
[[nodiscard]] std::vector<std::vector<AxiomSet>> groups_of(const std::vector<AxiomSet>& sets);

/// All minimal sets that have an axiom of each of these, up to limits: the smallest first, and sets of one size in
/// ascending order. The sets are ascending; one that is empty cannot be hit, and then there is none.
[[nodiscard]] AllSets find_hitting_sets(const std::vector<AxiomSet>& sets, const ExplanationLimits& limits = {});

}  // namespace geminga::explanation

#endif
