#include "reasoning/syntax/files.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "base/hash.hpp"
#include "base/text.hpp"
#include "reasoning/syntax/file_reading.hpp"
#include "reasoning/syntax/long_text_watch.hpp"

namespace geminga::syntax {
namespace {

std::unexpected<LoadError> refuse(const std::string& file, std::string text) {
  return std::unexpected(LoadError{base::printable(file, 4096), 0, std::move(text), true});
}

std::string kernel_words(int error) { return std::generic_category().message(error); }

/// The words for a file that is not a regular one.
std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "is a folder";
  if (S_ISFIFO(mode)) return "is a FIFO";
  if (S_ISSOCK(mode)) return "is a socket";
  return "is a device";
}

}  // namespace

FileBytes::FileBytes(FileBytes&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      mapped_(std::exchange(other.mapped_, 0)),
      hash_(std::exchange(other.hash_, std::nullopt)) {}

FileBytes& FileBytes::operator=(FileBytes&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  std::swap(mapped_, other.mapped_);
  std::swap(hash_, other.hash_);
  return *this;
}

FileBytes::~FileBytes() {
  if (mapped_ != 0) munmap(data_, mapped_);
}

std::uint64_t FileBytes::hash() const { return hash_ ? *hash_ : base::hash64(view()); }

std::size_t FileBytes::release(std::size_t begin, std::size_t end) {
  constexpr std::size_t page = std::size_t{1} << 16;  // coarser than any page that Linux uses for this
  begin = (begin + page - 1) / page * page;
  end = std::min(end, size_) / page * page;
  if (end <= begin) return begin;
  madvise(data_ + begin, end - begin, MADV_DONTNEED);
  return end;
}

std::expected<FileBytes, LoadError> FileBytes::read(const std::string& path, const FileLimits& limits,
                                                    unsigned threads) {
  struct stat status{};
  // Asked by name first: opening a device or a FIFO can have effects of its own.
  if (stat(path.c_str(), &status) != 0) return refuse(path, "cannot be opened: " + kernel_words(errno));
  if (!S_ISREG(status.st_mode)) return refuse(path, std::string(kind_of(status.st_mode)) + ", not a regular file");
  const int file = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (file < 0) return refuse(path, "cannot be opened: " + kernel_words(errno));
  struct Closer {
    int file;
    ~Closer() { close(file); }
  } closer{file};
  if (fstat(file, &status) != 0) return refuse(path, "cannot be read: " + kernel_words(errno));
  if (!S_ISREG(status.st_mode)) return refuse(path, std::string(kind_of(status.st_mode)) + ", not a regular file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > limits.file_bytes)
    return refuse(path, "is larger than " + std::to_string(limits.file_bytes) + " bytes: split it");

  // A file that is being written is not read by halves. Files of /proc, too, hold more than they say.
  const auto has_more = [&] {
    char next = 0;
    return ::read(file, &next, 1) > 0;
  };
  const std::string grew = "became longer while it was read: try again";
  FileBytes bytes;
  if (size == 0) return has_more() ? refuse(path, grew) : std::expected<FileBytes, LoadError>(std::move(bytes));
  void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return refuse(path, "is too large for the memory: " + kernel_words(errno));
  bytes.data_ = static_cast<char*>(memory);
  bytes.mapped_ = size;
  FileReading reading(path, file, bytes.data_, size, limits);
  auto error = reading.run(threads);
  if (error) return std::unexpected(std::move(*error));
  bytes.size_ = reading.size();
  bytes.hash_ = reading.hash();
  if (has_more()) return refuse(path, grew);
  return bytes;
}

std::expected<FileBytes, LoadError> FileBytes::read_standard_input(const FileLimits& limits) {
  const std::string path(standard_input_name);
  FileBytes bytes;
  for (;;) {
    char* const room = bytes.room_for(FileReading::block_bytes);
    if (room == nullptr) return refuse(path, "is too large for the memory");
    const ssize_t count = ::read(STDIN_FILENO, room, FileReading::block_bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return refuse(path, "cannot be read: " + kernel_words(errno));
    if (count == 0) break;
    bytes.take_room(static_cast<std::size_t>(count));
    if (bytes.view().size() > limits.file_bytes) {
      return refuse(path, "is larger than " + std::to_string(limits.file_bytes) + " bytes: split it");
    }
  }
  bytes.give_back_room();
  LongTextWatch watch(path, bytes.view().size(), limits);
  if (auto error = watch.look_at(bytes.view())) return std::unexpected(std::move(*error));
  return bytes;
}

std::optional<FileBytes> FileBytes::copy_of(std::string_view text) {
  FileBytes bytes;
  char* const room = bytes.room_for(text.size());
  if (room == nullptr) return std::nullopt;
  std::ranges::copy(text, room);
  bytes.take_room(text.size());
  bytes.give_back_room();
  return bytes;
}

char* FileBytes::room_for(std::size_t count) {
  constexpr std::size_t step = std::size_t{1} << 20;
  if (mapped_ != 0 && mapped_ - size_ >= count) return data_ + size_;
  const std::size_t wanted =
      (std::max({size_ + count, mapped_ + mapped_ / 2, std::size_t{1}}) + step - 1) / step * step;
  void* memory = mapped_ == 0 ? mmap(nullptr, wanted, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)
                              : mremap(data_, mapped_, wanted, MREMAP_MAYMOVE);
  if (memory == MAP_FAILED) return nullptr;
  data_ = static_cast<char*>(memory);
  mapped_ = wanted;
  return data_ + size_;
}

std::string_view FileBytes::take_room(std::size_t count) {
  const std::string_view taken(data_ + size_, count);
  size_ += count;
  hash_.reset();
  return taken;
}

void FileBytes::give_back_room() {
  constexpr std::size_t page = std::size_t{1} << 16;
  const std::size_t needed = (std::max<std::size_t>(size_, 1) + page - 1) / page * page;
  if (needed >= mapped_ || mremap(data_, mapped_, needed, 0) == MAP_FAILED) return;
  mapped_ = needed;
}

}  // namespace geminga::syntax
