// Limits of a document that is written.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_LIMITS_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_LIMITS_HPP

#include <cstddef>

namespace geminga::writing {

struct WritingLimits {
  /// Of the whole text. Terms may share their parts, so that a few lines of a file can mean a text without end.
  std::size_t octets = std::size_t{1} << 32;
};

}  // namespace geminga::writing

#endif
