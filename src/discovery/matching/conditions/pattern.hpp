// Patterns: texts in which each `*` stands for any octets.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_PATTERN_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_PATTERN_HPP

#include <string_view>

namespace geminga::matching {

/// Whether `text` is the pattern with any octets, or none, in the place of each `*`. Each piece between two stars is
/// searched once, behind the piece before it: O(length of the text times length of the pattern).
[[nodiscard]] bool is_like(std::string_view text, std::string_view pattern);

}  // namespace geminga::matching

#endif
