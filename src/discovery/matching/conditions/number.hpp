// Numbers as WHERE.md defines them.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_NUMBER_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_NUMBER_HPP

#include <compare>
#include <cstddef>
#include <optional>
#include <string_view>

namespace geminga::matching {

/// How many octets at the beginning have the form `[sign] digits [ "." digits ] [ "e" [sign] digits ]`, whatever the
/// size of the number; 0: none. An `e` without digits behind it is not part of the number.
[[nodiscard]] std::size_t number_length(std::string_view text);

/// The value of a text that is a number as a whole; nothing where it has another form or is not finite.
[[nodiscard]] std::optional<double> number(std::string_view text);

/// The nearest number of 14 decimal digits, in which 70 * 0.01 and 0.7 are equal. Requires a finite number.
[[nodiscard]] double rounded(double value);

/// Compares whole numbers of 64 bits exactly, all others as doubles. Requires two texts that are numbers.
[[nodiscard]] std::partial_ordering compare_numbers(std::string_view a, std::string_view b);

}  // namespace geminga::matching

#endif
