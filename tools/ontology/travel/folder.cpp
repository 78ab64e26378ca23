#include "ontology/travel/folder.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "base/numbered_folders.hpp"
#include "base/text.hpp"

namespace geminga::ontology {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view partial_ending = ".part";
constexpr std::chrono::hours max_partial_age{1};

std::string words_of(int error) { return std::generic_category().message(error); }

fs::path parent_of(const fs::path& folder) {
  const fs::path parent = folder.parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

/// Whether the octets of a file are these.
bool has_content(const fs::path& file, std::string_view content) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error)) || fs::file_size(file, error) != content.size())
    return false;
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {}) == content;
}

/// Writes a new file and waits until it is on the disk; the system's error, or 0.
int write_new(const fs::path& file, std::string_view content) {
  const int out = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (out < 0) return errno;
  int error = 0;
  while (error == 0 && !content.empty()) {
    const ssize_t written = ::write(out, content.data(), content.size());
    if (written >= 0) {
      content.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (error == 0 && ::fsync(out) != 0) error = errno;
  if (::close(out) != 0 && error == 0) error = errno;
  return error;
}

/// Waits until the entries of a folder are on the disk. A file system that cannot is left alone.
void settle(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

/// Removes a folder of files, and nothing below a folder in it.
void remove_flat(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
    files.push_back(entry->path());
  for (const fs::path& file : files) ::unlink(file.c_str());
  ::rmdir(folder.c_str());
}

/// Removes what writers that were cut off have left beside the folder.
void remove_partial(const fs::path& folder) {
  const std::string begin = '.' + folder.filename().string() + '.';
  std::vector<fs::path> stale;
  std::error_code error;
  for (fs::directory_iterator entry(parent_of(folder), error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (!name.starts_with(begin) || !name.ends_with(partial_ending) || !entry->is_directory(ignored)) continue;
    const auto written = fs::last_write_time(entry->path(), ignored);
    if (!ignored && fs::file_time_type::clock::now() - written > max_partial_age) stale.push_back(entry->path());
  }
  for (const fs::path& one : stale) remove_flat(one);
}

/// The name of a temporary folder beside `folder`.
fs::path partial_beside(const fs::path& folder, std::uint64_t tag) {
  return parent_of(folder) /
         ('.' + folder.filename().string() + '.' + base::to_hex(tag, 16) + std::string(partial_ending));
}

}  // namespace

std::uint64_t random_tag() {
  std::uint64_t tag = 0;
  // It gives so few octets whole; without any, a name that is taken is an error of its own.
  [[maybe_unused]] const ssize_t octets = ::getrandom(&tag, sizeof tag, 0);
  return tag;
}

void keep_newest_versions(const std::string& folder, std::size_t kept, std::uint64_t tag) {
  const std::vector<std::uint64_t> versions = base::numbered_folders(folder);
  for (std::size_t number = 0; number + kept < versions.size(); ++number) {
    const fs::path version = fs::path(folder) / std::to_string(versions[number]);
    const fs::path partial = partial_beside(version, tag);
    if (std::rename(version.c_str(), partial.c_str()) == 0) remove_flat(partial);
  }
}

bool holds(const std::string& folder, const Manifest& manifest, std::string_view content) {
  std::error_code error;
  std::size_t entries = 0;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
    ++entries;
  if (error || entries != manifest.files.size()) return false;
  for (const TravellingFile& file : manifest.files) {
    if (!has_content(fs::path(folder) / file.name, content.substr(0, file.octets))) return false;
    content.remove_prefix(file.octets);
  }
  return true;
}

std::expected<Written, std::string> write_folder(const std::string& folder, const Manifest& manifest,
                                                 std::string_view content, std::uint64_t tag) {
  if (holds(folder, manifest, content)) return Written::was_there;
  fs::path path = fs::path(folder).lexically_normal();
  if (path.filename().empty()) path = path.parent_path();
  std::error_code error;
  if (fs::exists(fs::symlink_status(path, error)) && (!fs::is_directory(path, error) || !fs::is_empty(path, error)))
    return std::unexpected(folder + ": holds something else: name another folder, or remove it first");
  remove_partial(path);
  const fs::path partial = partial_beside(path, tag);
  if (::mkdir(partial.c_str(), 0777) != 0)
    return std::unexpected(parent_of(path).string() + ": no folder can be made in it: " + words_of(errno));
  int failure = 0;
  for (const TravellingFile& file : manifest.files) {
    if (failure == 0) failure = write_new(partial / file.name, content.substr(0, file.octets));
    content.remove_prefix(file.octets);
  }
  settle(partial);
  if (failure == 0 && std::rename(partial.c_str(), path.c_str()) != 0) failure = errno;
  if (failure != 0) {
    remove_flat(partial);
    return std::unexpected(folder + ": cannot be written: " + words_of(failure));
  }
  settle(parent_of(path));
  return Written::made;
}

}  // namespace geminga::ontology
