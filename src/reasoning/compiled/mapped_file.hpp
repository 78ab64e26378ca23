// The octets of a file in memory, read-only, for as long as the object lives.
#ifndef GEMINGA_REASONING_COMPILED_MAPPED_FILE_HPP
#define GEMINGA_REASONING_COMPILED_MAPPED_FILE_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace geminga::compiled {

/// Maps a private copy of a regular file. A mapping of the file itself would change under its reader, and end the
/// process, whenever somebody writes into the file or cuts it short; `cp new.geminga in-use.geminga` does both. The
/// copy never changes once it is made. If the file changes while it is copied, the copy is a mixture, and its checksums
/// tell.
class MappedFile {
 public:
  /// Looks at the beginning and the size of a file before all of it is copied, and returns a line about what is wrong.
  using Look = std::function<std::expected<void, std::string>(std::span<const std::byte>, std::uint64_t)>;
  static constexpr std::size_t beginning_bytes = 64;

  /// Copies the file at `path`. On a disk the copy has no name, and only the pages that are read take memory. It lies
  /// beside the file, or else in TMPDIR, /var/tmp or /tmp, whichever is the first on a local disk with room. If none
  /// is, it lies in memory. The error is one line that names the file. Linear in the file, except on file systems that
  /// share blocks.
  [[nodiscard]] static std::expected<MappedFile, std::string> copy_of(const std::string& path, const Look& look);
  /// The folders in which the copy of this file may lie, in their order: its own comes first, because there the copy
  /// may share its blocks. Of an empty path: those that every file has.
  [[nodiscard]] static std::vector<std::string> folders_for(const std::string& path);
  /// Whether a copy of this file would lie in memory.
  [[nodiscard]] static bool needs_memory(const std::string& path);

  MappedFile() = default;
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  ~MappedFile();

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

 private:
  explicit MappedFile(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::span<const std::byte> bytes_;
};

}  // namespace geminga::compiled

#endif
