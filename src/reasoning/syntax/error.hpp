// Why a file was refused: the file, the line if there is one, and what is wrong.
#ifndef GEMINGA_REASONING_SYNTAX_ERROR_HPP
#define GEMINGA_REASONING_SYNTAX_ERROR_HPP

#include <cstdint>
#include <string>

namespace geminga::syntax {

/// A file that was refused. The text is one line of UTF-8, which ends in what to do unless that is plain.
struct LoadError {
  std::string file;
  std::uint32_t line = 0;  ///< 0: the file as a whole
  std::string text;
  /// Nothing of it could be read: no such file, no permission, a device, damaged packing, no known syntax.
  bool is_unreadable = false;
};

/// "soccer.ttl:17: what is wrong", or "soccer.ttl: what is wrong" where there is no line.
[[nodiscard]] inline std::string to_string(const LoadError& error) {
  std::string text = error.file;
  if (error.line != 0) text += ':' + std::to_string(error.line);
  if (!text.empty()) text += ": ";
  return text + error.text;
}

}  // namespace geminga::syntax

#endif
