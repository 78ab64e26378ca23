// The repairs of axioms with ill-typed literals that make a difference.
//
// A repair has some value of the datatype in place of an ill-typed literal such as "twelve"^^xsd:integer. These values
// fall into classes: a range, a literal or a bound of the same properties distinguishes one class from another. Nothing
// distinguishes two values of one class, so exchanging them turns a model into a model. So one value of each class is
// enough. If values may be counted, as many are taken as there are ill-typed literals.
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

/// If there are more repairs, none is asked about.
inline constexpr std::size_t max_repairs = 64;

/// The axioms of each repair, or why not all repairs are known. `ill_typed` has numbers of ill-typed axioms of the
/// source, to which the literals of the repairs are added.
[[nodiscard]] std::expected<std::vector<std::vector<Statement>>, std::string> find_repairs(
    owl::Ontology& source, std::span<const std::uint32_t> premise, std::span<const std::uint32_t> conclusion,
    std::span<const std::size_t> ill_typed);

}  // namespace geminga::reasoner

#endif
