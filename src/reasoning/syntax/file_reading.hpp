// Reads a file into memory block by block, and looks at each block: whether it has a text that is too long, and what
// the hash of the file is. One thread may look at a block while another reads the next ones.
#ifndef GEMINGA_REASONING_SYNTAX_FILE_READING_HPP
#define GEMINGA_REASONING_SYNTAX_FILE_READING_HPP

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "base/hash.hpp"
#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/long_text_watch.hpp"

namespace geminga::syntax {

/// One reading of one open file. Borrows the path and the limits.
class FileReading {
 public:
  /// The octets of one call of the system.
  static constexpr std::size_t block_bytes = std::size_t{1} << 20;
  /// The most octets that are read and not looked at yet: they are in memory when a file is refused.
  static constexpr std::size_t ahead_bytes = std::size_t{8} << 20;

  /// `file` is the descriptor of `path`. Reads `size` octets to `memory`.
  FileReading(const std::string& path, int file, char* memory, std::size_t size, const FileLimits& limits);

  /// Reads everything, or up to the first error, whichever thread finds it. Two threads take a file that is watched,
  /// if so many may be used and the system gives one.
  [[nodiscard]] std::optional<LoadError> run(unsigned threads);
  /// The octets that were read.
  [[nodiscard]] std::size_t size() const { return read_; }
  /// base::hash64() of them.
  [[nodiscard]] std::uint64_t hash() const { return hash_.finish(); }

 private:
  void run_in_turn();
  void run_at_once();
  void read_on();
  void look_on();
  /// Reads the next block. Returns how much there is then, as much as before at an error.
  [[nodiscard]] std::size_t read_block(std::size_t from);
  void look_at(std::size_t begin, std::size_t end);

  const std::string& path_;
  int file_;
  char* memory_;
  std::size_t size_;
  bool is_watched_;
  LongTextWatch watch_;
  base::HashOfPieces hash_;
  std::optional<LoadError> reading_error_;
  std::optional<LoadError> text_error_;

  std::mutex mutex_;  ///< guards the members below while two threads are at work
  std::condition_variable changed_;
  std::size_t read_ = 0;
  std::size_t looked_at_ = 0;
  bool has_read_ = false;    ///< everything, or up to an error
  bool has_looked_ = false;  ///< likewise
};

}  // namespace geminga::syntax

#endif
