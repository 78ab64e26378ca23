// Cuts the bytes of a stream into GCNP lines of bounded length, in whatever pieces they arrive.
#ifndef GEMINGA_DISCOVERY_GCNP_LINE_READER_HPP
#define GEMINGA_DISCOVERY_GCNP_LINE_READER_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "discovery/gcnp/statement.hpp"

namespace geminga::gcnp {

/// A line ends with CR LF or a bare LF, which are not part of it. A line over the limit is told once, by its beginning,
/// as soon as it is known to be too long; the rest is skipped to its end. Keeps at most the limit and what was fed
/// last. Linear in what is fed. Not thread-safe.
class LineReader {
 public:
  struct Line {
    std::string_view text;  ///< borrowed until the next feed()
    bool is_too_long = false;
  };

  /// The octets of a line over the limit that are given, so that the id of its statement can be told.
  static constexpr std::size_t beginning_bytes = 64;

  explicit LineReader(std::size_t max_bytes = max_line_bytes) : max_bytes_(max_bytes) {}

  /// Takes the next bytes of the stream. Lines that next() has not given yet remain.
  void feed(std::string_view bytes);
  /// The next line, or nothing until more is fed. An empty line is a line.
  [[nodiscard]] std::optional<Line> next();
  /// Whether next() would give a line.
  [[nodiscard]] bool has_line();

 private:
  /// A line by its position in the buffer.
  struct Found {
    std::size_t begin = 0;
    std::size_t size = 0;
    bool is_too_long = false;
  };
  std::optional<Found> find();

  std::size_t max_bytes_;
  std::string buffer_;
  std::size_t begin_ = 0;    ///< the beginning of the first line that was not found yet
  std::size_t scanned_ = 0;  ///< the octets without LF that were searched
  bool is_skipping_ = false;
  std::optional<Found> found_;  ///< found by has_line() and not given yet
};

}  // namespace geminga::gcnp

#endif
