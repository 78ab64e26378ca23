// The beginnings and ends of characters in UTF-8 (RFC 3629).
#ifndef GEMINGA_BASE_UTF8_HPP
#define GEMINGA_BASE_UTF8_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::base {

/// The number of octets of the character that begins with this octet; 1 if none does.
[[nodiscard]] constexpr std::size_t character_bytes(unsigned char lead) {
  if (lead < 0xc0) return 1;
  if (lead < 0xe0) return 2;
  return lead < 0xf0 ? 3 : 4;
}

/// The character at a place of well-formed UTF-8.
[[nodiscard]] char32_t character_at(const char* place);

/// Adds a character. Requires that it is no surrogate and at most U+10FFFF.
void append_character(char32_t character, std::string& text);

/// The position of the first octets that are no UTF-8; nothing in well-formed text. Fast over ASCII.
[[nodiscard]] std::optional<std::size_t> find_invalid_utf8(std::string_view bytes);

/// The number of characters of well-formed UTF-8.
[[nodiscard]] std::size_t count_characters(std::string_view text);

/// As much of the text as fits into so many octets, never cut inside a character.
[[nodiscard]] std::string_view first_characters(std::string_view text, std::size_t max_bytes);

}  // namespace geminga::base

#endif
