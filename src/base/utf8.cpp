#include "base/utf8.hpp"

#include <utf8.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>

#include "base/text.hpp"

namespace geminga::base {
namespace {

/// Whether an octet is neither ASCII nor the first one of a character.
bool is_continuation(char octet) { return (static_cast<unsigned char>(octet) & 0xc0U) == 0x80U; }

}  // namespace

char32_t character_at(const char* place) { return utf8::unchecked::peek_next(place); }

void append_character(char32_t character, std::string& text) { utf8::append(character, std::back_inserter(text)); }

std::optional<std::size_t> find_invalid_utf8(std::string_view bytes) {
  std::size_t place = 0;
  while (place < bytes.size()) {
    std::array<std::uint64_t, 4> words{};
    if (bytes.size() - place >= sizeof words) {  // 32 characters of ASCII at a time
      std::memcpy(words.data(), bytes.data() + place, sizeof words);
      if (((words[0] | words[1] | words[2] | words[3]) & 0x8080808080808080U) == 0) {
        place += sizeof words;
        continue;
      }
    }
    const auto lead = static_cast<unsigned char>(bytes[place]);
    const std::size_t count = character_bytes(lead);
    if (lead >= 0x80 && !is_valid_utf8(bytes.substr(place, count))) return place;
    place += count;
  }
  return std::nullopt;
}

std::size_t count_characters(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, is_continuation));
}

std::string_view first_characters(std::string_view text, std::size_t max_bytes) {
  if (text.size() <= max_bytes) return text;
  std::size_t end = max_bytes;
  while (end > 0 && is_continuation(text[end])) --end;
  return text.substr(0, end);
}

}  // namespace geminga::base
