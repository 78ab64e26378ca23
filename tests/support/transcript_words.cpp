#include "support/transcript_words.hpp"

#include <algorithm>
#include <regex>
#include <vector>

namespace geminga::test {
namespace {

std::string escaped(std::string_view text) {
  static const std::regex special(R"([.^$|()\[\]{}*+?\\])");
  return std::regex_replace(std::string(text), special, R"(\$&)");
}

}  // namespace

std::string next_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  const std::size_t end = std::min(rest.find(' '), rest.size());
  std::string word(rest.substr(0, end));
  rest.remove_prefix(end);
  return word;
}

std::string unescaped(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      bytes += text[i];
      continue;
    }
    const char kind = text[++i];
    if (kind == 'x') {
      bytes += static_cast<char>(std::stoi(std::string(text.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    } else {
      bytes += kind == 'r' ? '\r' : kind == 'n' ? '\n' : kind == 't' ? '\t' : kind;
    }
  }
  return bytes;
}

std::optional<std::string> BoundWords::substituted(std::string_view text) const {
  std::string result;
  while (!text.empty()) {
    const std::size_t open = text.find('{');
    const std::size_t close = text.find('}', open);
    result += text.substr(0, open);
    if (open == std::string_view::npos || close == std::string_view::npos) return result;
    const std::string name(text.substr(open + 1, close - open - 1));
    const std::size_t star = name.find('*');
    if (star != std::string::npos) {
      for (std::size_t i = std::stoul(name.substr(star + 1)); i > 0; --i) result += name.substr(0, star);
    } else {
      if (!bound_.contains(name)) return std::nullopt;
      result += bound_.at(name);
    }
    text.remove_prefix(close + 1);
  }
  return result;
}

bool BoundWords::matches(std::string_view pattern, const std::string& text) {
  std::string expression;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < pattern.size();) {
    if (pattern.substr(i).starts_with("...")) {
      expression += ".*";
      i += 3;
    } else if (const std::size_t close = pattern.find('}', i); pattern[i] == '{' && close != std::string_view::npos) {
      const std::string name(pattern.substr(i + 1, close - i - 1));
      if (bound_.contains(name)) {
        expression += escaped(bound_.at(name));
      } else {
        names.push_back(name);
        expression += "([^ /]+)";
      }
      i = close + 1;
    } else {
      expression += escaped(pattern.substr(i, 1));
      ++i;
    }
  }
  std::smatch match;
  if (!std::regex_match(text, match, std::regex(expression))) return false;
  for (std::size_t i = 0; i < names.size(); ++i) bound_[names[i]] = match[i + 1];
  return true;
}

}  // namespace geminga::test
