// Small texts: numbers, UTF-8, hexadecimal, cutting, and making a text fit to be shown.
#ifndef GEMINGA_BASE_TEXT_HPP
#define GEMINGA_BASE_TEXT_HPP

#include <charconv>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace geminga::base {

/// Whether the bytes are well-formed UTF-8 (RFC 3629).
[[nodiscard]] bool is_valid_utf8(std::string_view bytes);

/// Whether any byte is a C0 control character or DEL.
[[nodiscard]] bool has_control_character(std::string_view bytes);

/// The number that the whole text is in decimal, without white space or anything behind it, and without sign for
/// unsigned types; or nothing.
template <std::integral Number>
[[nodiscard]] std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// A 32-bit number in decimal, or behind `0x` in hexadecimal; or nothing.
[[nodiscard]] std::optional<std::uint32_t> parse_id32(std::string_view text);

/// Exactly `digits` lower-case hexadecimal digits of `number`.
[[nodiscard]] std::string to_hex(std::uint64_t number, int digits);

/// The text with a to z for A to Z, and nothing else changed.
[[nodiscard]] std::string in_lower_case(std::string_view text);

/// Whether an octet may be in a key of GCNP or a name of an attribute: A to Z, a to z, 0 to 9, `_`, `.` and `-`.
[[nodiscard]] constexpr bool is_key_octet(char octet) {
  return (octet >= 'a' && octet <= 'z') || (octet >= 'A' && octet <= 'Z') || (octet >= '0' && octet <= '9') ||
         octet == '_' || octet == '.' || octet == '-';
}
/// Whether a text is one or more of these octets.
[[nodiscard]] bool is_key(std::string_view text);

/// The text without spaces, tabs and line ends at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The text without the byte order mark that some editors begin UTF-8 with.
[[nodiscard]] std::string_view without_mark(std::string_view bytes);

/// The words with `separator` between them.
[[nodiscard]] std::string joined(std::span<const std::string> words, std::string_view separator);

/// A text from outside, made fit to be shown in one line: bad UTF-8 is replaced, what a terminal could obey
/// (base/harmless.hpp) becomes `?`, and a text over `max_bytes` is cut at a character and ends in `...`.
[[nodiscard]] std::string printable(std::string_view bytes, std::size_t max_bytes = 120);

}  // namespace geminga::base

#endif
