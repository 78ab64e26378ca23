// The file that a recording is written to.
#ifndef GEMINGA_RECORDING_RECORDING_FILE_HPP
#define GEMINGA_RECORDING_RECORDING_FILE_HPP

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

#include "recording/entry.hpp"

namespace geminga::recording {

/// The most time that a loss of power takes from the end of a recording. Shorter: less is lost, and a memory card
/// writes more often. Longer: the reverse.
inline constexpr At sync_interval = std::chrono::seconds(2);

/// Writes whole lines, each at once. Moves and does not copy.
class RecordingFile {
 public:
  /// Opens the file, or standard output for `-`. A file that is there is refused, unless `appends`: then lines go
  /// behind it, and a line that was cut gets an end. The error is one line that says what to do.
  [[nodiscard]] static std::expected<RecordingFile, std::string> open(const std::string& path, bool appends);
  ~RecordingFile();
  RecordingFile(RecordingFile&& other) noexcept;
  RecordingFile& operator=(RecordingFile&&) = delete;

  /// Writes lines, and syncs them where that is due. The error is one line, e.g. that the disk is full.
  [[nodiscard]] std::expected<void, std::string> write(std::string_view lines, At now);
  [[nodiscard]] std::uint64_t written() const { return written_; }

 private:
  RecordingFile(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}
  [[nodiscard]] std::expected<void, std::string> write_all(std::string_view octets);

  std::string path_;
  int descriptor_;
  std::uint64_t written_ = 0;
  bool is_unsynced_ = false;
  At synced_{};
};

}  // namespace geminga::recording

#endif
