// Why a file in functional-style syntax was refused: where, and what is wrong.
#ifndef GEMINGA_FUNCTIONAL_ERROR_HPP
#define GEMINGA_FUNCTIONAL_ERROR_HPP

#include <cstdint>
#include <string>

namespace geminga::functional {

/// One refused file. Its text is one line of UTF-8.
struct ReadError {
  std::string file;
  std::uint32_t line = 0;  ///< 0: the file as a whole
  std::string text;
};

/// "soma.owl:17: what is wrong", or "soma.owl: what is wrong" where there is no line.
[[nodiscard]] inline std::string to_string(const ReadError& error) {
  std::string text = error.file;
  if (error.line != 0) text += ':' + std::to_string(error.line);
  if (!text.empty()) text += ": ";
  return text + error.text;
}

}  // namespace geminga::functional

#endif
