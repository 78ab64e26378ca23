// Lists folders and reads files with nothing but plain system calls, so that what is opened is plain, too.
#include "rdf/files.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "rdf/long_text.hpp"
#include "rdf/syntax.hpp"

namespace geminga::rdf {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t read_at_once = std::size_t{1} << 20;

constexpr std::array<std::string_view, 7> extensions{".ttl", ".nt", ".rdf", ".owl", ".xml", ".ofn", ".fss"};

std::unexpected<LoadError> refuse(std::string file, std::string text) {
  return std::unexpected(LoadError{base::printable(file, 4096), 0, std::move(text), true});
}

/// Where a file is large, a text that is beyond its limit refuses it before the rest of it is read.
class LongTextWatch {
 public:
  LongTextWatch(const std::string& path, std::size_t size, const Limits& limits)
      : path_(path), limits_(limits), is_needed_(size > limits.watched_bytes) {}

  std::optional<LoadError> look_at(std::string_view stretch) {
    if (!is_needed_) return std::nullopt;
    if (!text_) {
      const auto syntax = detect_syntax(path_, stretch);
      is_needed_ = syntax.has_value();
      if (!is_needed_) return std::nullopt;  // whoever asked for the bytes says why
      is_xml_ = *syntax == Syntax::rdf_xml;
      // A text may be half escapes, and in XML stand in a tag with others.
      text_.emplace(*syntax, is_xml_ ? std::max(limits_.tag_bytes, limits_.literal_bytes) : 2 * limits_.literal_bytes,
                    limits_.blank_bytes);
    }
    const auto line = text_->look_at(stretch);
    if (!line) return std::nullopt;
    const bool is_blank = text_->is_blank();
    const std::string_view what = is_blank ? "white space and comments" : is_xml_ ? "a text" : "a literal";
    return LoadError{base::printable(path_, 4096), *line,
                     "has " + std::string(what) + " of more than " +
                         std::to_string(is_blank ? limits_.blank_bytes : limits_.literal_bytes) + " bytes"};
  }

 private:
  const std::string& path_;
  const Limits& limits_;
  bool is_needed_;
  bool is_xml_ = false;
  std::optional<LongText> text_;
};

std::string kernel_words(int error) { return std::generic_category().message(error); }

/// The words for a file that is not a regular one.
std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "is a folder";
  if (S_ISFIFO(mode)) return "is a FIFO";
  if (S_ISSOCK(mode)) return "is a socket";
  return "is a device";
}

bool is_ontology_name(std::string_view name) {
  if (name.starts_with('.') || name.starts_with("catalog-v")) return false;
  return std::ranges::any_of(extensions, [&](std::string_view extension) { return name.ends_with(extension); });
}

std::expected<std::vector<std::string>, LoadError> list_folder(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> names;
  fs::directory_iterator entries(folder, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    std::string name = entries->path().filename().string();
    if (is_ontology_name(name)) names.push_back(std::move(name));
  }
  if (error) return refuse(folder, "cannot be listed: " + error.message());
  std::ranges::sort(names);
  const fs::path inside = fs::canonical(folder, error);
  if (error) return refuse(folder, "cannot be resolved: " + error.message());
  std::vector<std::string> files;
  for (const std::string& name : names) {
    const fs::path path = fs::path(folder) / name;
    const fs::path target = fs::canonical(path, error);
    if (error) return refuse(path.string(), "cannot be resolved: " + error.message());
    const auto [end, rest] = std::mismatch(inside.begin(), inside.end(), target.begin(), target.end());
    if (end != inside.end())
      return refuse(path.string(), "is a link that leads out of its folder: name the file itself");
    if (fs::is_directory(target, error)) continue;
    files.push_back(path.string());
  }
  if (files.empty())
    return refuse(folder, "holds no ontology file: put files named .ttl, .nt, .rdf, .owl, .xml or .ofn there");
  return files;
}

}  // namespace

FileBytes::FileBytes(FileBytes&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      mapped_(std::exchange(other.mapped_, 0)) {}

FileBytes& FileBytes::operator=(FileBytes&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  std::swap(mapped_, other.mapped_);
  return *this;
}

FileBytes::~FileBytes() {
  if (mapped_ != 0) munmap(data_, mapped_);
}

std::size_t FileBytes::release(std::size_t begin, std::size_t end) {
  constexpr std::size_t page = std::size_t{1} << 16;  // coarser than any page that Linux uses for this
  begin = (begin + page - 1) / page * page;
  end = std::min(end, size_) / page * page;
  if (end <= begin) return begin;
  madvise(data_ + begin, end - begin, MADV_DONTNEED);
  return end;
}

std::expected<FileBytes, LoadError> FileBytes::read(const std::string& path, const Limits& limits) {
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
  LongTextWatch watch(path, size, limits);
  while (bytes.size_ < size) {
    const ssize_t count = ::read(file, bytes.data_ + bytes.size_, std::min(size - bytes.size_, read_at_once));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return refuse(path, "cannot be read: " + kernel_words(errno));
    if (count == 0) return refuse(path, "became shorter while it was read: try again");
    bytes.size_ += static_cast<std::size_t>(count);
    if (auto error = watch.look_at(bytes.view().substr(bytes.size_ - static_cast<std::size_t>(count))))
      return std::unexpected(std::move(*error));
  }
  if (has_more()) return refuse(path, grew);
  return bytes;
}

std::expected<std::vector<std::string>, LoadError> list_files(std::span<const std::string> arguments,
                                                              const Limits& limits) {
  std::vector<std::string> files;
  std::set<std::pair<dev_t, ino_t>> seen;
  const auto take = [&](std::string path) {
    struct stat status{};
    if (stat(path.c_str(), &status) == 0 && !seen.emplace(status.st_dev, status.st_ino).second) return;
    files.push_back(std::move(path));
  };
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!fs::is_directory(argument, error)) {
      take(argument);
      continue;
    }
    auto inside = list_folder(argument);
    if (!inside) return std::unexpected(std::move(inside.error()));
    for (std::string& path : *inside) take(std::move(path));
  }
  if (files.size() > limits.files)
    return refuse("", "more than " + std::to_string(limits.files) + " ontology files are named: merge some");
  return files;
}

}  // namespace geminga::rdf
