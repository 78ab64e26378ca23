// Texts from outside made harmless for a terminal. Every program prints such texts through one of these functions, or
// through base::printable().
#ifndef GEMINGA_BASE_HARMLESS_HPP
#define GEMINGA_BASE_HARMLESS_HPP

#include <string>
#include <string_view>

namespace geminga::base {

/// Whether a terminal could obey this character: control characters (C0, DEL, C1), those that turn the direction of
/// writing (Unicode Standard Annex 9, section 2), and those that end a line.
[[nodiscard]] bool is_harmful(char32_t character);

/// Makes a text one harmless line: bad UTF-8 becomes U+FFFD, and each harmful character becomes `instead`. O(length).
[[nodiscard]] std::string harmless(std::string_view text, std::string_view instead = "\ufffd");

/// The same for a text of many lines: line feeds, the carriage returns right before them, and tabs stay.
[[nodiscard]] std::string harmless_lines(std::string_view text);

/// The same JSON document with every harmful character as an escape (RFC 8259, section 7), so that it means the same.
/// Requires a document whose control characters below U+0020 are escaped, or blanks between its tokens.
[[nodiscard]] std::string harmless_json(std::string_view document);

}  // namespace geminga::base

#endif
