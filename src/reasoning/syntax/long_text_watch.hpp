// Refuses a large file with a text beyond its limit before the rest of the file is in memory.
#ifndef GEMINGA_REASONING_SYNTAX_LONG_TEXT_WATCH_HPP
#define GEMINGA_REASONING_SYNTAX_LONG_TEXT_WATCH_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/long_text.hpp"

namespace geminga::syntax {

/// Watches the reading of one file. Path and limits must outlive it.
class LongTextWatch {
 public:
  /// `size` is how large the file is expected to be. A small one is not watched.
  LongTextWatch(const std::string& path, std::size_t size, const FileLimits& limits)
      : path_(path), limits_(limits), is_needed_(size > limits.watched_bytes) {}

  /// Takes the next stretch of the file; the first one tells its syntax. Returns why the file is refused, if it is.
  std::optional<LoadError> look_at(std::string_view stretch);

 private:
  /// The name of the stretch that was too long, and the limit that a user is told.
  [[nodiscard]] std::pair<std::string_view, std::size_t> beyond() const;

  const std::string& path_;
  const FileLimits& limits_;
  bool is_needed_;
  bool is_xml_ = false;
  std::optional<LongText> text_;
};

}  // namespace geminga::syntax

#endif
