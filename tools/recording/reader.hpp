// Reads the entries of a recording from a stream, and goes on behind every line that cannot be read.
#ifndef GEMINGA_RECORDING_READER_HPP
#define GEMINGA_RECORDING_READER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <istream>
#include <optional>
#include <string>

#include "recording/entry.hpp"

namespace geminga::recording {

/// Something wrong in a recording, and where.
struct Finding {
  std::size_t line = 0;     ///< from 1
  std::uint64_t octet = 0;  ///< of the beginning of the line, from 0
  std::string text;
};

/// `line 7, octet 1034: is no JSON object`
[[nodiscard]] std::string to_string(const Finding& finding);

/// Entries before the first snapshot are left out and reported once, since nothing is known of the state before them.
/// Times never run backwards: where they do in the file, as where two recordings were joined, it is reported, and time
/// goes on from the entry before. Keeps one line. Not thread-safe.
class Reader {
 public:
  using Report = std::function<void(const Finding&)>;

  /// Borrows the stream for its life. `report` is told of each line that is left out or mended.
  Reader(std::istream& in, Report report) : in_(in), report_(std::move(report)) {}

  /// The next entry that can be read, or nothing at the end. The error says why nothing is read any more: it is no
  /// recording, or one of another version.
  [[nodiscard]] std::expected<std::optional<Entry>, Finding> next();

  /// Begins anew at the first line, and reports nothing twice. False: the stream cannot go back, as a pipe cannot.
  [[nodiscard]] bool rewind();

 private:
  enum class Cut { whole, too_long, unended, none };
  /// Reads one line into line_, at most max_line_bytes of it.
  Cut cut();
  [[nodiscard]] Finding here(std::string text) const { return {line_number_, line_begin_, std::move(text)}; }
  void mend_time(Entry& entry);
  void report(const Finding& finding);

  std::istream& in_;
  Report report_;
  std::string line_;
  std::size_t line_number_ = 0;
  std::uint64_t line_begin_ = 0;
  std::uint64_t read_ = 0;
  std::size_t read_before_ = 0;  ///< lines that were read before rewind()
  std::size_t left_out_ = 0;     ///< entries before the first snapshot
  bool has_begun_ = false;
  At last_{};
  At shift_{};  ///< added to the times of the file
};

}  // namespace geminga::recording

#endif
