// A file without a name that only this process has.
#ifndef GEMINGA_BASE_PRIVATE_FILE_HPP
#define GEMINGA_BASE_PRIVATE_FILE_HPP

#include <cstddef>
#include <expected>
#include <span>
#include <string>

namespace geminga::base {

/// No other process can open, change or shorten it. Nothing is left of it when its last descriptor is closed.
class PrivateFile {
 public:
  /// Makes a file in the first of these folders that lies on a local disk and has room for `size` octets, which is
  /// reserved. The error, one line, is that there is none.
  [[nodiscard]] static std::expected<PrivateFile, std::string> on_disk(std::span<const std::string> folders,
                                                                       std::size_t size);
  /// Makes a file in memory. All of its octets count as the system's memory, and those that were read as this
  /// process's.
  [[nodiscard]] static std::expected<PrivateFile, std::string> in_memory();

  PrivateFile(PrivateFile&& other) noexcept;
  PrivateFile& operator=(PrivateFile&& other) noexcept;
  ~PrivateFile();

  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// Copies the beginning of `from`, at most `most` octets, to the beginning of this file. Returns their number: fewer
  /// if that file is shorter, and any number if another process changes it meanwhile. Shares the disk's blocks if the
  /// file system can. The error is the system's reason.
  [[nodiscard]] std::expected<std::size_t, std::string> copy_from(int from, std::size_t most);

 private:
  explicit PrivateFile(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace geminga::base

#endif
