// The octets of a file in memory, read-only, for as long as the object lives.
#ifndef GEMINGA_REASONING_COMPILED_MAPPED_FILE_HPP
#define GEMINGA_REASONING_COMPILED_MAPPED_FILE_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <span>
#include <string>

namespace geminga::compiled {

/// Maps a private copy of a regular file. A mapping of the file itself would change under its reader, and end the
/// process, whenever somebody writes into the file or cuts it short (`cp new.geminga in-use.geminga` does both). What
/// the copy holds never changes once it is made; a file that is changed while it is copied gives some mixture of both,
/// which its checksums tell.
class MappedFile {
 public:
  /// Looks at the beginning of a file and at its size, and gives a line about what is wrong, before all is copied.
  using Look = std::function<std::expected<void, std::string>(std::span<const std::byte>, std::uint64_t)>;
  static constexpr std::size_t beginning_bytes = 64;

  /// Copies the file at `path`. On a disk the copy has no name, and costs no memory but for what is looked at. It lies
  /// beside the file, else in TMPDIR, /var/tmp or /tmp, whichever is the first on a local disk with room; in memory
  /// where none is. The error is one line that names the file. Cost: linear in the file, but for file systems that
  /// share blocks.
  [[nodiscard]] static std::expected<MappedFile, std::string> copy_of(const std::string& path, const Look& look);
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
