// Why a document in Manchester syntax was refused: where, and what is wrong.
#ifndef GEMINGA_FRAMES_ERROR_HPP
#define GEMINGA_FRAMES_ERROR_HPP

#include <cstdint>
#include <string>

namespace geminga::frames {

/// One refused file. Its text is one line of UTF-8.
struct ReadError {
  std::string file;
  std::uint32_t line = 0;  ///< 0: the file as a whole
  std::string text;
};

}  // namespace geminga::frames

#endif
