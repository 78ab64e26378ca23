// The language stands behind the last @, if it is one.
#include "reasoning/owl/plain_literal.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace geminga::owl {

bool is_language_tag(std::string_view tag) {
  constexpr std::size_t max_subtag = 8;
  constexpr std::size_t min_language = 2;
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::size_t begin = 0;
  while (begin <= tag.size()) {
    const std::size_t end = std::min(tag.find('-', begin), tag.size());
    const std::string_view subtag = tag.substr(begin, end - begin);
    if (subtag.empty() || subtag.size() > max_subtag) return false;
    // Digits stand behind the language only. `x` and `i` begin private and old tags.
    const bool is_first = begin == 0;
    if (is_first && subtag.size() < min_language && (end == tag.size() || (subtag != "x" && subtag != "i")))
      return false;
    if (!std::ranges::all_of(subtag, [&](char c) { return is_letter(c) || (!is_first && c >= '0' && c <= '9'); }))
      return false;
    begin = end + 1;
  }
  return true;
}

PlainLiteral split_plain_literal(std::string_view lexical) {
  const std::size_t at = lexical.rfind('@');
  if (at == std::string_view::npos) return {lexical, {}};
  const std::string_view tag = lexical.substr(at + 1);
  if (!tag.empty() && !is_language_tag(tag)) return {lexical, {}};
  return {lexical.substr(0, at), base::in_lower_case(tag)};
}

}  // namespace geminga::owl
