#include "base/harmless.hpp"

#include <utf8.h>

#include <algorithm>
#include <iterator>

#include "base/text.hpp"

namespace geminga::base {
namespace {

/// An object and no function, so that the loops over octets contain it.
constexpr auto is_plain_octet = [](char octet) { return octet >= 0x20 && octet < 0x7f; };

/// Copies what has no plain octet. See copied().
template <typename Keeps, typename Replace>
void copy_special(std::string_view text, Keeps keeps, Replace replace, std::string& copy) {
  std::string valid;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  for (auto at = valid.begin(); at != valid.end();) {
    const auto begin = at;
    const char32_t character = utf8::next(at, valid.end());
    if (is_harmful(character) && !keeps(character, at == valid.end() ? '\0' : *at)) {
      replace(character, copy);
    } else {
      copy.append(begin, at);
    }
  }
}

/// Copies a text. Calls `replace` for each harmful character that `keeps` does not keep, to add what stands for it. A
/// plain octet ends every character before it, so stretches of plain octets are copied as they are.
template <typename Keeps, typename Replace>
std::string copied(std::string_view text, Keeps keeps, Replace replace) {
  std::string copy;
  copy.reserve(text.size());
  for (auto at = text.begin(); at != text.end();) {
    const auto special = std::find_if_not(at, text.end(), is_plain_octet);
    copy.append(at, special);
    at = std::find_if(special, text.end(), is_plain_octet);
    if (special != at) copy_special({special, at}, keeps, replace, copy);
  }
  return copy;
}

}  // namespace

bool is_harmful(char32_t c) {
  const bool is_control = c < 0x20 || (c >= 0x7f && c < 0xa0);
  const bool turns_direction =
      c == 0x061c || c == 0x200e || c == 0x200f || (c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
  const bool breaks_line = c == 0x2028 || c == 0x2029;
  return is_control || turns_direction || breaks_line;
}

std::string harmless(std::string_view text, std::string_view instead) {
  const auto keeps = [](char32_t, char) { return false; };
  return copied(text, keeps, [instead](char32_t, std::string& copy) { copy += instead; });
}

std::string harmless_lines(std::string_view text) {
  const auto keeps = [](char32_t character, char next) {
    return character == '\n' || character == '\t' || (character == '\r' && next == '\n');
  };
  return copied(text, keeps, [](char32_t, std::string& copy) { copy += "\ufffd"; });
}

std::string harmless_json(std::string_view document) {
  const auto keeps = [](char32_t character, char) {
    return character == '\n' || character == '\t' || character == '\r';
  };
  return copied(document, keeps, [](char32_t character, std::string& copy) { copy += "\\u" + to_hex(character, 4); });
}

}  // namespace geminga::base
