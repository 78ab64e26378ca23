#include "base/letter_case.hpp"

#include <cstddef>

#include "base/utf8.hpp"

namespace geminga::base {
namespace {

constexpr char32_t between = 0x20;  // a capital and its small letter

bool is_small(char32_t letter) {
  return (letter >= U'a' && letter <= U'z') || (letter >= 0xe0 && letter <= 0xfe && letter != 0xf7);
}

std::optional<char32_t> letter_in_case(char32_t letter, LetterCase wanted) {
  // The capitals of the first two are not in Latin-1.
  if ((wanted == LetterCase::upper && (letter == 0xb5 || letter == 0xdf)) || letter >= 0xff) return std::nullopt;
  if (wanted == LetterCase::upper) return is_small(letter) ? letter - between : letter;
  return is_small(letter + between) ? letter + between : letter;
}

}  // namespace

std::optional<std::string> in_case(std::string_view text, LetterCase wanted) {
  std::string changed;
  for (std::size_t at = 0; at < text.size(); at += character_bytes(static_cast<unsigned char>(text[at]))) {
    const auto letter = letter_in_case(character_at(text.data() + at), wanted);
    if (!letter) return std::nullopt;
    append_character(*letter, changed);
  }
  return changed;
}

}  // namespace geminga::base
