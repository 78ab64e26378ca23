// Numbers as WHERE.md defines them.
#ifndef GEMINGA_DISCOVERY_MATCHING_NUMBER_HPP
#define GEMINGA_DISCOVERY_MATCHING_NUMBER_HPP

#include <compare>
#include <cstddef>
#include <optional>
#include <string_view>

namespace geminga::matching {

/// How many octets at the beginning have the form `[sign] digits [ "." digits ] [ "e" [sign] digits ]`, whatever the
/// number's size; 0: none. An `e` that no digits follow is not part of it.
[[nodiscard]] std::size_t number_length(std::string_view text);

/// The number that the whole text is; nothing where it has another form or is not finite.
[[nodiscard]] std::optional<double> number(std::string_view text);

/// The nearest number of 14 decimal digits: 70 * 0.01 and 0.7 are the same there. Requires that it is finite.
[[nodiscard]] double rounded(double value);

/// Whole numbers of 64 bits are compared exactly, all others as doubles. Requires two numbers.
[[nodiscard]] std::partial_ordering compare_numbers(std::string_view a, std::string_view b);

}  // namespace geminga::matching

#endif
