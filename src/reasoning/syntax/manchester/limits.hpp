// The most that one class expression may be.
#ifndef GEMINGA_REASONING_SYNTAX_MANCHESTER_LIMITS_HPP
#define GEMINGA_REASONING_SYNTAX_MANCHESTER_LIMITS_HPP

#include <cstddef>

namespace geminga::manchester {

/// An expression that exceeds one of these is refused with its column. MANCHESTER.md names the same numbers.
struct ExpressionLimits {
  std::size_t text_bytes = std::size_t{1} << 16;
  /// Levels of parentheses, `not` and restrictions: the reader descends once for each.
  std::size_t nesting = 100;
  /// Names, literals and restrictions of one expression, each as often as it occurs.
  std::size_t parts = 4096;
};

}  // namespace geminga::manchester

#endif
