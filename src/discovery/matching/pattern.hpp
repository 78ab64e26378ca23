// Texts in which a `*` stands for any octets.
#ifndef GEMINGA_DISCOVERY_MATCHING_PATTERN_HPP
#define GEMINGA_DISCOVERY_MATCHING_PATTERN_HPP

#include <string_view>

namespace geminga::matching {

/// Whether `text` is the pattern with something, or nothing, in the place of each `*`. Each piece between two of them
/// is looked for once, behind the one before it: O(length of the text times that of the pattern).
[[nodiscard]] bool is_like(std::string_view text, std::string_view pattern);

}  // namespace geminga::matching

#endif
