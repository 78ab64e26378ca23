// How far two words are from each other when one of them was mistyped.
#ifndef GEMINGA_BASE_EDIT_DISTANCE_HPP
#define GEMINGA_BASE_EDIT_DISTANCE_HPP

#include <cstddef>
#include <string_view>

namespace geminga::base {

/// Longer words are no slips of the keyboard, and would only cost time.
inline constexpr std::size_t max_compared_bytes = 200;

/// Octets to be changed, added, left out or swapped with their neighbour, or `limit` + 1 where these are more than
/// `limit` or a word is longer than max_compared_bytes (Damerau 1964, as optimal string alignment). The case of ASCII
/// letters does not count. Costs at most the product of the lengths, much less where the words differ early, and
/// allocates nothing.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// How many wrong letters still make `word` a slip of the keyboard: a third of it, at most three.
[[nodiscard]] std::size_t tolerated_slips(std::string_view word);

}  // namespace geminga::base

#endif
