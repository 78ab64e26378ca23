// Answers that take account of axioms whose literals are damaged: no is no however these axioms were meant.
#ifndef GEMINGA_REASONING_REASONER_DAMAGED_HPP
#define GEMINGA_REASONING_REASONER_DAMAGED_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::reasoner {

/// As entails_each(), of a premise to which the axioms `damaged` of the source belong, too. Each of their damaged
/// literals is taken for some value of the datatype that it names. What follows without these axioms follows; what
/// follows in no reading of them does not; all else is unknown. The source gets the readings.
[[nodiscard]] std::vector<Answer> entails_each(owl::Ontology& source, std::span<const std::uint32_t> premise,
                                               std::span<const std::uint32_t> conclusion,
                                               std::span<const std::size_t> damaged, base::Budget* budget = nullptr);

/// As is_consistent(), of a source with all its damaged axioms: yes where each reading of them has a model.
[[nodiscard]] Answer is_consistent_as_meant(owl::Ontology& source, base::Budget* budget = nullptr);

}  // namespace geminga::reasoner

#endif
