// Regular expressions of XPath, as the built-ins of SWRL use them, by RE2 in linear time.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_PATTERNS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_PATTERNS_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::hypertableau {

/// Longer patterns are not used.
inline constexpr std::size_t max_pattern_octets = 1024;

/// A pattern (XQuery 1.0 and XPath 2.0 Functions and Operators, section 7.6.1; XML Schema part 2, appendix F, without
/// flags) in the syntax of RE2. Nothing for what RE2 has not or means otherwise (RULES.md): a pattern that is no
/// regular expression, back-references, subtraction of classes, blocks, names of XML, unassigned characters.
[[nodiscard]] std::optional<std::string> as_re2(std::string_view pattern);

/// Whether some part of a text matches; nothing where that is not known. In time linear in the text.
[[nodiscard]] std::optional<bool> has_match(std::string_view text, std::string_view pattern);

/// The text with each match replaced (section 7.6.3): $1 to $9 are groups, $0 the match, \$ and \\ characters. Nothing
/// where the pattern is not known, matches the empty text, or the replacement is none; or the result would be longer
/// than `most` octets.
[[nodiscard]] std::optional<std::string> replaced(std::string_view text, std::string_view pattern,
                                                  std::string_view replacement, std::size_t most);

}  // namespace geminga::hypertableau

#endif
