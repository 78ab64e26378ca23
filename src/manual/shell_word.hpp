// A text as one word of a shell.
#ifndef GEMINGA_MANUAL_SHELL_WORD_HPP
#define GEMINGA_MANUAL_SHELL_WORD_HPP

#include <string>
#include <string_view>

namespace geminga::manual {

/// Puts a text between single quotes, where a shell takes every character as it stands.
[[nodiscard]] inline std::string shell_word(std::string_view text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + '\'';
}

}  // namespace geminga::manual

#endif
