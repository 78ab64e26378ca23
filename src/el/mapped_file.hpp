// A file in memory, read-only, for as long as the object lives.
#ifndef GEMINGA_EL_MAPPED_FILE_HPP
#define GEMINGA_EL_MAPPED_FILE_HPP

#include <cstddef>
#include <expected>
#include <span>
#include <string>

namespace geminga::el {

/// Maps a regular file. The file must not be changed in place while it is mapped: writers put a new one in its place.
class MappedFile {
 public:
  /// The error is one line that names the file.
  [[nodiscard]] static std::expected<MappedFile, std::string> open(const std::string& path);
  MappedFile() = default;
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  ~MappedFile();

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

 private:
  explicit MappedFile(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::span<const std::byte> bytes_;
};

}  // namespace geminga::el

#endif
