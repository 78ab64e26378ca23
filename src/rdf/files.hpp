// From what the user names, files and folders, to the bytes of ontology files, without touching anything else.
#ifndef GEMINGA_RDF_FILES_HPP
#define GEMINGA_RDF_FILES_HPP

#include <cstddef>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rdf/error.hpp"
#include "rdf/limits.hpp"

namespace geminga::rdf {

/// The bytes of one file in memory of their own, given back to the kernel piece by piece as they are used up.
class FileBytes {
 public:
  FileBytes() = default;
  FileBytes(FileBytes&& other) noexcept;
  FileBytes& operator=(FileBytes&& other) noexcept;
  ~FileBytes();

  /// Reads a regular file as a whole. Never blocks on a FIFO or a device, and never opens one.
  [[nodiscard]] static std::expected<FileBytes, LoadError> read(const std::string& path, const Limits& limits);

  [[nodiscard]] std::string_view view() const { return {data_, size_}; }
  /// What stands between two places will not be read again: its memory is released as far as it is whole pages, and
  /// reads as zero. Gives the end of what was released. Several threads may release what only they read.
  std::size_t release(std::size_t begin, std::size_t end);

 private:
  char* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t mapped_ = 0;
};

/// The files that the arguments mean: a file is itself; a folder is every ontology file in it (.ttl .nt .rdf .owl
/// .xml .ofn .fss), sorted by name, not those in folders below, not hidden ones and not a Protégé catalogue. What is
/// named twice is taken once. A folder without any is an error, and so is one that holds a link that leads out of it, a
/// FIFO or a device.
[[nodiscard]] std::expected<std::vector<std::string>, LoadError> list_files(std::span<const std::string> arguments,
                                                                            const Limits& limits);

}  // namespace geminga::rdf

#endif
