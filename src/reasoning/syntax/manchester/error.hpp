// Why a text is not a class expression.
#ifndef GEMINGA_REASONING_SYNTAX_MANCHESTER_ERROR_HPP
#define GEMINGA_REASONING_SYNTAX_MANCHESTER_ERROR_HPP

#include <cstddef>
#include <cstdint>
#include <string>

namespace geminga::manchester {

/// An error in a text, and its place.
struct ParseError {
  enum class Kind : std::uint8_t {
    malformed,  ///< not in the grammar
    name,       ///< a name that is unknown or may mean several things
    too_large,  ///< over one of the limits
  };
  Kind kind = Kind::malformed;
  std::size_t column = 1;  ///< from 1, in characters
  std::string text;        ///< one line: "expected a class or '(', found 'and'"
};

/// "column 8: expected a class or '(', found 'and'".
[[nodiscard]] inline std::string to_string(const ParseError& error) {
  return "column " + std::to_string(error.column) + ": " + error.text;
}

}  // namespace geminga::manchester

#endif
