// Letters of ASCII and Latin-1 in upper and in lower case (Unicode, simple case mapping).
#ifndef GEMINGA_BASE_LETTER_CASE_HPP
#define GEMINGA_BASE_LETTER_CASE_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::base {

enum class LetterCase : std::uint8_t { upper, lower };

/// Well-formed UTF-8 with each letter in this case; nothing if a character is beyond Latin-1 or has there no letter of
/// that case (the capital of U+00DF is two letters).
[[nodiscard]] std::optional<std::string> in_case(std::string_view text, LetterCase wanted);

}  // namespace geminga::base

#endif
