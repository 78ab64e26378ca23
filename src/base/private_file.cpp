#include "base/private_file.hpp"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/mman.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

namespace geminga::base {
namespace {

constexpr std::uint32_t xfs_magic = 0x58465342;  // <linux/magic.h> does not have it
/// The file systems on local disks. A server or a program that goes away does not kill a process that maps their files,
/// and their octets are not in memory twice.
constexpr std::array<std::uint32_t, 5> disks{EXT4_SUPER_MAGIC, xfs_magic, BTRFS_SUPER_MAGIC, F2FS_SUPER_MAGIC,
                                             OVERLAYFS_SUPER_MAGIC};
/// Octets that are copied by one call.
constexpr std::size_t piece_bytes = std::size_t{1} << 30U;
/// The same if the kernel cannot copy between the two file systems by itself.
constexpr std::size_t buffer_bytes = std::size_t{1} << 16U;

std::string reason() { return std::generic_category().message(errno); }

bool is_on_disk(int descriptor) {
  struct statfs status{};
  return ::fstatfs(descriptor, &status) == 0 &&
         std::ranges::find(disks, static_cast<std::uint32_t>(status.f_type)) != disks.end();
}

/// Reserves room for so many octets if the file system can; if not, copying finds out.
bool has_room(int descriptor, std::size_t size) {
  return size == 0 || ::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(size)) == 0 ||
         (errno != ENOSPC && errno != EDQUOT && errno != EFBIG);
}

/// Reads once, and writes all that was read. Returns 0 at the end of the file; nothing with errno.
std::optional<std::size_t> copy_by_hand(int from, off_t at, int to, std::size_t most) {
  std::array<char, buffer_bytes> buffer;
  const ssize_t got = ::pread(from, buffer.data(), std::min(most, buffer.size()), at);
  if (got < 0) return std::nullopt;
  for (ssize_t done = 0; done < got;) {
    const ssize_t put = ::write(to, buffer.data() + done, static_cast<std::size_t>(got - done));
    if (put < 0 && errno != EINTR) return std::nullopt;
    done += std::max<ssize_t>(put, 0);
  }
  return static_cast<std::size_t>(got);
}

}  // namespace

std::expected<PrivateFile, std::string> PrivateFile::on_disk(std::span<const std::string> folders, std::size_t size) {
  for (const std::string& folder : folders) {
    if (folder.empty()) continue;
    // O_EXCL: it can never be given a name.
    const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_EXCL | O_RDWR | O_CLOEXEC, 0600);
    if (descriptor < 0) continue;
    PrivateFile file(descriptor);
    if (is_on_disk(descriptor) && has_room(descriptor, size)) return file;
  }
  return std::unexpected("no folder on a local disk has room for a file");
}

std::expected<PrivateFile, std::string> PrivateFile::in_memory() {
  const int descriptor = ::memfd_create("geminga", MFD_CLOEXEC);
  if (descriptor < 0) return std::unexpected("no file can be made in memory: " + reason());
  return PrivateFile(descriptor);
}

PrivateFile::PrivateFile(PrivateFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

PrivateFile& PrivateFile::operator=(PrivateFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

PrivateFile::~PrivateFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::expected<std::size_t, std::string> PrivateFile::copy_from(int from, std::size_t most) {
  off_t at = 0;
  bool is_by_hand = false;
  while (static_cast<std::size_t>(at) < most) {
    const std::size_t left = most - static_cast<std::size_t>(at);
    if (is_by_hand) {
      const auto count = copy_by_hand(from, at, descriptor_, left);
      if (!count && errno == EINTR) continue;
      if (!count) return std::unexpected(reason());
      if (*count == 0) break;
      at += static_cast<off_t>(*count);
      continue;
    }
    const ssize_t count = ::copy_file_range(from, &at, descriptor_, nullptr, std::min(left, piece_bytes), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == ENOSPC || errno == EDQUOT || errno == EIO || errno == EFBIG))
      return std::unexpected(reason());
    // It fails for other reasons, or returns 0, between file systems, on older kernels and for files of /proc.
    is_by_hand = count <= 0;
  }
  return static_cast<std::size_t>(at);
}

}  // namespace geminga::base
