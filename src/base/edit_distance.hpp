// The distance between two words of which one may be mistyped.
#ifndef GEMINGA_BASE_EDIT_DISTANCE_HPP
#define GEMINGA_BASE_EDIT_DISTANCE_HPP

#include <cstddef>
#include <string_view>

namespace geminga::base {

/// The longest word that is compared. Longer ones are not mistyped, and would only cost time.
inline constexpr std::size_t max_compared_bytes = 200;

/// The number of octets to change, add, leave out or swap with their neighbour; `limit` + 1 if there are more than
/// `limit` or a word is longer than max_compared_bytes (Damerau 1964, as optimal string alignment). The case of ASCII
/// letters does not count. Costs at most the product of the lengths, much less if the words differ early, and allocates
/// nothing.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// The number of wrong letters with which `word` still counts as mistyped: a third of it, at most three.
[[nodiscard]] std::size_t tolerated_slips(std::string_view word);

}  // namespace geminga::base

#endif
