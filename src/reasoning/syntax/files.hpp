// The bytes of one file, read with nothing but plain system calls, so that what is opened is plain, too.
#ifndef GEMINGA_REASONING_SYNTAX_FILES_HPP
#define GEMINGA_REASONING_SYNTAX_FILES_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/limits.hpp"

namespace geminga::syntax {

/// The name by which a user means standard input.
inline constexpr std::string_view standard_input_name = "-";

/// The octets of one file in memory of their own, which goes back to the kernel piece by piece as they are used.
class FileBytes {
 public:
  FileBytes() = default;
  FileBytes(FileBytes&& other) noexcept;
  FileBytes& operator=(FileBytes&& other) noexcept;
  ~FileBytes();

  /// Reads a regular file as a whole. Never blocks on a FIFO or a device, and never opens one. A second thread, if
  /// there may be one, looks at a large file while it is read.
  [[nodiscard]] static std::expected<FileBytes, LoadError> read(const std::string& path, const FileLimits& limits,
                                                                unsigned threads = 1);

  /// Reads standard input to its end. Waits for it.
  [[nodiscard]] static std::expected<FileBytes, LoadError> read_standard_input(const FileLimits& limits);

  /// The octets of a text; nothing if there is no memory.
  [[nodiscard]] static std::optional<FileBytes> copy_of(std::string_view text);

  [[nodiscard]] std::string_view view() const { return {data_, size_}; }
  /// base::hash64() of the content. Free of cost for a file that was read as it is. To be asked before octets are
  /// released.
  [[nodiscard]] std::uint64_t hash() const;
  /// Says that what is between two places will not be read again. Whole pages of it are released and then read as zero.
  /// Returns the end of what was released. Several threads may release what only they read.
  std::size_t release(std::size_t begin, std::size_t end);

  /// Room for this many octets, which may be none, behind the content, which may move. nullptr if there is no memory.
  [[nodiscard]] char* room_for(std::size_t count);
  /// Adds the first `count` octets of that room to the file, and returns them.
  std::string_view take_room(std::size_t count);
  /// Says that nothing more will be added.
  void give_back_room();

 private:
  char* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t mapped_ = 0;
  std::optional<std::uint64_t> hash_;  ///< of the content; nothing: not computed yet
};

}  // namespace geminga::syntax

#endif
