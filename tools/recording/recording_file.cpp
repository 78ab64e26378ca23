#include "recording/recording_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace geminga::recording {
namespace {

std::string system_text() { return std::error_code(errno, std::generic_category()).message(); }

}  // namespace

std::expected<RecordingFile, std::string> RecordingFile::open(const std::string& path, bool appends) {
  if (path == "-") {
    const int output = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (output < 0) return std::unexpected("standard output: " + system_text());
    return RecordingFile("standard output", output);
  }
  const int flags = O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC | (appends ? 0 : O_EXCL);
  const int descriptor = ::open(path.c_str(), flags, 0644);
  if (descriptor < 0 && errno == EEXIST) {
    return std::unexpected(path + " is there already: choose another name, or --append to go on behind it");
  }
  if (descriptor < 0) return std::unexpected(path + " cannot be written: " + system_text());
  RecordingFile file(path, descriptor);
  char last = '\n';
  const off_t size = ::lseek(descriptor, 0, SEEK_END);
  if (size > 0 && ::pread(descriptor, &last, 1, size - 1) == 1 && last != '\n') {
    if (auto ended = file.write_all("\n"); !ended) return std::unexpected(std::move(ended.error()));
  }
  return file;
}

RecordingFile::~RecordingFile() {
  if (descriptor_ < 0) return;
  if (is_unsynced_) ::fdatasync(descriptor_);
  ::close(descriptor_);
}

RecordingFile::RecordingFile(RecordingFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      written_(other.written_),
      is_unsynced_(other.is_unsynced_),
      synced_(other.synced_) {}

std::expected<void, std::string> RecordingFile::write_all(std::string_view octets) {
  while (!octets.empty()) {
    const ssize_t size = ::write(descriptor_, octets.data(), octets.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) {
      return std::unexpected(path_ + " cannot be written: " + system_text() +
                             ": what was recorded until then is in it");
    }
    written_ += static_cast<std::uint64_t>(size);
    octets.remove_prefix(static_cast<std::size_t>(size));
    is_unsynced_ = true;
  }
  return {};
}

std::expected<void, std::string> RecordingFile::write(std::string_view lines, At now) {
  if (auto done = write_all(lines); !done) return done;
  if (is_unsynced_ && now - synced_ >= sync_interval) {
    ::fdatasync(descriptor_);  // a pipe or terminal has nothing to sync, which is no error
    is_unsynced_ = false;
    synced_ = now;
  }
  return {};
}

}  // namespace geminga::recording
