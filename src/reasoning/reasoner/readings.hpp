// What axioms whose literals are damaged may have meant: every reading that makes a difference.
//
// A damaged literal ("twelve"^^xsd:integer) is taken for some value of the datatype that it names. These values fall
// into classes: a range, a literal or a bound beside the same properties tells one class from another, and nothing
// tells two values of one class apart, so that exchanging them makes a model of a model. One value of each class is
// enough to ask for; where values may be counted, as many as there are damaged literals.
#ifndef GEMINGA_REASONING_REASONER_READINGS_HPP
#define GEMINGA_REASONING_REASONER_READINGS_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <vector>

#include "reasoning/reasoner/excerpt.hpp"

namespace geminga::reasoner {

/// Beyond so many readings it is not asked at all.
inline constexpr std::size_t max_readings = 64;

/// Axioms in place of the damaged ones, reading by reading; or why not all readings are known. `damaged` has the
/// numbers of damaged axioms of the source, which gets the literals that they may have meant.
[[nodiscard]] std::expected<std::vector<std::vector<Statement>>, std::string> find_readings(
    owl::Ontology& source, std::span<const std::uint32_t> premise, std::span<const std::uint32_t> conclusion,
    std::span<const std::size_t> damaged);

}  // namespace geminga::reasoner

#endif
