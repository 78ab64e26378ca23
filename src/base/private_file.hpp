// A file without a name that only this process has.
#ifndef GEMINGA_BASE_PRIVATE_FILE_HPP
#define GEMINGA_BASE_PRIVATE_FILE_HPP

#include <cstddef>
#include <expected>
#include <span>
#include <string>

namespace geminga::base {

/// Nobody else can open it, change it or cut it short, and nothing is left of it when its last descriptor is closed.
class PrivateFile {
 public:
  /// In the first of these folders that lies on a local disk and has room for `size` octets, which is kept for them.
  /// The error, a line, is that none has.
  [[nodiscard]] static std::expected<PrivateFile, std::string> on_disk(std::span<const std::string> folders,
                                                                       std::size_t size);
  /// In memory: all of its octets count as the system's memory, and those that were looked at as this process's.
  [[nodiscard]] static std::expected<PrivateFile, std::string> in_memory();

  PrivateFile(PrivateFile&& other) noexcept;
  PrivateFile& operator=(PrivateFile&& other) noexcept;
  ~PrivateFile();

  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// Writes, from the beginning, what `from` holds from its beginning on, at most `most` octets, and gives their
  /// number: less where the file is shorter, and anything where somebody changes it meanwhile. Shares the disk's blocks
  /// where the file system can. The error is the system's reason.
  [[nodiscard]] std::expected<std::size_t, std::string> copy_from(int from, std::size_t most);

 private:
  explicit PrivateFile(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace geminga::base

#endif
