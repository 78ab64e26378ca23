// That one representation can be turned into another: the two annotations that say so. They mean nothing to the
// reasoner (src/discovery/matching/CONVERSIONS.md).
#ifndef GEMINGA_REASONING_OWL_CONVERSION_HPP
#define GEMINGA_REASONING_OWL_CONVERSION_HPP

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geminga::owl {

/// Annotates the class that is turned with the class that comes of it.
inline constexpr std::string_view converts_to = "https://geminga.example/core#convertsTo";
/// Annotates that annotation with what it costs.
inline constexpr std::string_view conversion_cost = "https://geminga.example/core#conversionCost";

/// The constructs under which conversions are left out, as users are told.
inline constexpr std::string_view conversion_to_literal = "geminga:convertsTo with a literal: name a class";
inline constexpr std::string_view conversion_without_name = "geminga:convertsTo from or to what has no name";
inline constexpr std::string_view cost_of_nothing = "geminga:conversionCost of no geminga:convertsTo that is stated";

/// The most conversions of one ontology.
inline constexpr std::size_t max_conversions = 1024;
/// The highest cost of a conversion, and the cost if none is stated.
inline constexpr std::uint32_t max_conversion_cost = 1'000'000;
inline constexpr std::uint32_t usual_conversion_cost = 1;

}  // namespace geminga::owl

#endif
