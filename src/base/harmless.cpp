#include "base/harmless.hpp"

#include <utf8.h>

#include <algorithm>
#include <iterator>

#include "base/text.hpp"

namespace geminga::base {
namespace {

bool is_plain_octet(char octet) { return octet >= 0x20 && octet < 0x7f; }

/// Copies a text. Calls `replace` for each harmful character that `keeps` does not keep, to add what stands for it.
template <typename Keeps, typename Replace>
std::string copied(std::string_view text, Keeps keeps, Replace replace) {
  if (std::ranges::all_of(text, is_plain_octet)) return std::string(text);
  std::string valid;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  std::string copy;
  copy.reserve(valid.size());
  for (auto at = valid.begin(); at != valid.end();) {
    const auto begin = at;
    const char32_t character = utf8::next(at, valid.end());
    if (is_harmful(character) && !keeps(character, at == valid.end() ? '\0' : *at)) {
      replace(character, copy);
    } else {
      copy.append(begin, at);
    }
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
