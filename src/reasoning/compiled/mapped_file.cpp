// Copies the file, then maps the copy.
#include "reasoning/compiled/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/private_file.hpp"

namespace geminga::compiled {
namespace {

struct Closer {
  int descriptor;
  ~Closer() { ::close(descriptor); }
};

std::expected<std::size_t, std::string> size_of(int descriptor, const MappedFile::Look& look) {
  struct stat status{};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::unexpected("is not a regular file");
  std::array<std::byte, MappedFile::beginning_bytes> beginning;
  const ssize_t got = ::pread(descriptor, beginning.data(), beginning.size(), 0);
  if (got < 0) return std::unexpected("cannot be read: " + std::string(std::strerror(errno)));
  const auto size = static_cast<std::size_t>(status.st_size);
  const auto looked = look(std::span(beginning).first(static_cast<std::size_t>(got)), size);
  if (!looked) return std::unexpected(looked.error());
  return size;
}

/// Copies as many octets as the original is said to have.
std::expected<base::PrivateFile, std::string> copy(int descriptor, std::size_t size, const std::string& path) {
  auto copy = base::PrivateFile::on_disk(MappedFile::folders_for(path), size);
  if (!copy) copy = base::PrivateFile::in_memory();
  if (!copy) return std::unexpected("cannot be copied: " + copy.error());
  const auto count = copy->copy_from(descriptor, size);
  if (!count) return std::unexpected("cannot be copied: " + count.error());
  if (*count < size) return std::unexpected("became shorter while it was read: try again");
  return copy;
}

}  // namespace

std::expected<MappedFile, std::string> MappedFile::copy_of(const std::string& path, const Look& look) {
  const auto refuse = [&](const std::string& why) { return std::unexpected(path + ": " + why); };
  struct stat status{};
  // The name is asked first: opening a device can have effects of its own.
  if (::stat(path.c_str(), &status) != 0) return refuse("cannot be opened: " + std::string(std::strerror(errno)));
  if (!S_ISREG(status.st_mode)) return refuse("is not a regular file");
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return refuse("cannot be opened: " + std::string(std::strerror(errno)));
  const Closer closer{descriptor};
  const auto size = size_of(descriptor, look);
  if (!size) return refuse(size.error());
  if (*size == 0) return MappedFile();
  const auto own = copy(descriptor, *size, path);
  if (!own) return refuse(own.error());
  void* address = ::mmap(nullptr, *size, PROT_READ, MAP_PRIVATE, own->descriptor(), 0);
  if (address == MAP_FAILED) return refuse("cannot be mapped: " + std::string(std::strerror(errno)));
  return MappedFile({static_cast<const std::byte*>(address), *size});
}

std::vector<std::string> MappedFile::folders_for(const std::string& path) {
  std::vector<std::string> folders;
  if (!path.empty()) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    folders.push_back(folder.empty() ? "." : folder);
  }
  if (const char* named = std::getenv("TMPDIR")) folders.emplace_back(named);
  folders.insert(folders.end(), {"/var/tmp", "/tmp"});
  return folders;
}

bool MappedFile::needs_memory(const std::string& path) {
  struct stat status{};
  const auto size = ::stat(path.c_str(), &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
  return !base::PrivateFile::on_disk(folders_for(path), size);
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  std::swap(bytes_, other.bytes_);
  return *this;
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

}  // namespace geminga::compiled
