#include "ontology/command/output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <expected>
#include <filesystem>
#include <system_error>

#include "ontology/command/words.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {
namespace {

/// The most draft files that killed programs with the process number of this one can have left.
constexpr unsigned max_left_over = 100;

bool write_all(int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

/// The file that the symbolic links at a path lead to, which need not be there; the path itself where it is no link.
/// The error is that of a circle.
std::expected<std::filesystem::path, std::error_code> behind_links(std::filesystem::path path) {
  constexpr unsigned max_links = 40;  // as many as Linux follows
  std::error_code error;
  for (unsigned count = 0; count < max_links; ++count) {
    const std::filesystem::path next = std::filesystem::read_symlink(path, error);
    if (error) return path;
    path = path.parent_path() / next;
  }
  return std::unexpected(std::make_error_code(std::errc::too_many_symbolic_link_levels));
}

/// Writes beside the target and renames, so that at every instant the target is the old file or the whole new one. The
/// file is not forced to the disk, which would take most of the time: a file that a power cut damaged fails its
/// checksum. A symbolic link stays, and the file behind it is replaced.
Exit replace(const std::string& target, const std::function<std::optional<std::string>(const PutPiece&)>& write) {
  struct stat status{};
  if (stat(target.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
    return say_error(target + " is not a regular file: name another one behind -o");
  const auto written = behind_links(target);
  if (!written) return say_error(target + " cannot be written: " + written.error().message());
  const std::filesystem::path folder = written->parent_path();
  std::string temporary;
  const auto refuse = [&](const std::string& why) {
    unlink(temporary.c_str());
    return say_error(why);
  };
  const auto fail = [&](int error) {
    return refuse(target + " cannot be written: " + std::generic_category().message(error));
  };
  // For writing only: the folder of the output need not be one that may be read.
  int file = -1;
  errno = EEXIST;
  for (unsigned number = 0; file < 0 && errno == EEXIST && number < max_left_over; ++number) {
    temporary = (folder / (".geminga-ontology-" + std::to_string(getpid()) + '-' + std::to_string(number))).string();
    file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  }
  if (file < 0) return say_error(target + " cannot be written: " + std::generic_category().message(errno));
  const mode_t mask = umask(0);
  umask(mask);
  bool is_written = true;
  int error = 0;
  const auto problem = write([&](std::string_view piece) {
    is_written = write_all(file, std::as_bytes(std::span(piece)));
    error = errno;
    return is_written;
  });
  if (is_written && fchmod(file, static_cast<mode_t>(0666 & ~mask)) != 0) {
    is_written = false;
    error = errno;
  }
  if (close(file) != 0 || !is_written) return fail(error);
  if (problem) return refuse(*problem);
  if (std::rename(temporary.c_str(), written->c_str()) != 0) return fail(errno);
  return Exit::yes;
}

}  // namespace

Exit put(const std::string& out, std::span<const std::byte> bytes) {
  const std::string_view all{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  if (out != to_standard_output) {
    return replace(out, [&](const PutPiece& piece) -> std::optional<std::string> {
      static_cast<void>(piece(all));
      return std::nullopt;
    });
  }
  // The daemon reads a compiled form of any size there: it is not copied.
  if (isatty(STDOUT_FILENO) == 0) return write_all(STDOUT_FILENO, bytes) ? Exit::yes : say_unwritten();
  return print_or_say(std::string(all));
}

Exit put_pieces(const std::string& out, const std::function<std::optional<std::string>(const PutPiece&)>& write) {
  if (out != to_standard_output) return replace(out, write);
  bool is_written = true;
  const auto problem = write([&](std::string_view piece) {
    is_written = write_all(STDOUT_FILENO, std::as_bytes(std::span(piece)));
    return is_written;
  });
  if (!is_written) return say_unwritten();
  return problem ? say_error(*problem) : Exit::yes;
}

bool would_destroy_source(const std::string& out, const std::vector<std::string>& files, const owl::Ontology& source,
                          std::string_view flag) {
  const auto is_same = [&](const std::string& path) {
    std::error_code missing;
    return std::filesystem::equivalent(out, path, missing);
  };
  if (std::ranges::none_of(files, is_same) && std::ranges::none_of(source.files(), is_same, &owl::LoadedFile::path))
    return false;
  say_error(out + " is one of the sources: name another file behind " + std::string(flag));
  return true;
}

}  // namespace geminga::ontology
