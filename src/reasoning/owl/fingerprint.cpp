// Sizes and hashes of files.
#include "reasoning/owl/fingerprint.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <vector>

#include "base/hash.hpp"

namespace geminga::owl {
namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 18;

/// An open regular file, closed at the end.
class Reading {
 public:
  // Without O_NONBLOCK a FIFO would wait here for a writer.
  explicit Reading(const std::string& path) : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    struct stat status{};
    is_regular_ = descriptor_ >= 0 && ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
    if (is_regular_) size_ = static_cast<std::uint64_t>(status.st_size);
  }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  ~Reading() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  [[nodiscard]] bool is_regular() const { return is_regular_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// Nothing if reading fails before the end.
  [[nodiscard]] std::optional<Fingerprint> finish() {
    base::HashOfPieces hash;
    std::vector<char> piece(piece_bytes);
    Fingerprint result;
    for (;;) {
      const ::ssize_t got = ::read(descriptor_, piece.data(), piece.size());
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return std::nullopt;
      if (got == 0) break;
      hash.add({piece.data(), static_cast<std::size_t>(got)});
      result.size += static_cast<std::uint64_t>(got);
    }
    result.hash = hash.finish();
    return result;
  }

 private:
  int descriptor_;
  bool is_regular_ = false;
  std::uint64_t size_ = 0;
};

}  // namespace

Fingerprint fingerprint_of(std::string_view octets) { return {octets.size(), base::hash64(octets)}; }

bool has_changed(const std::string& path, const Fingerprint& known) {
  if (!known.is_known()) return false;
  Reading file(path);
  if (!file.is_regular()) return false;
  if (file.size() != known.size) return true;
  const auto now = file.finish();
  return now && *now != known;
}

}  // namespace geminga::owl
