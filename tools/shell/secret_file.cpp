#include "shell/secret_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace geminga::shell {
namespace {

/// The rights that a file with a secret gives to nobody.
mode_t forbidden(const std::string& path) {
  const char* credentials = std::getenv("CREDENTIALS_DIRECTORY");
  const bool is_credential =
      credentials != nullptr && *credentials != '\0' && path.starts_with(std::string(credentials) + '/');
  return is_credential ? S_IWGRP | S_IRWXO : S_IRWXG | S_IRWXO;
}

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

}  // namespace

std::expected<std::string, std::string> read_secret(const std::string& path) {
  const auto failure = [&](const std::string& what) { return std::unexpected(path + ": " + what); };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file < 0) return failure(std::generic_category().message(errno));
  struct stat status{};
  std::array<char, max_secret_file_octets> bytes{};
  const bool is_file = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  const ssize_t size = is_file ? ::read(file, bytes.data(), bytes.size()) : -1;
  ::close(file);
  if (size < 0) return failure("is no file that can be read");
  if ((status.st_mode & forbidden(path)) != 0) return failure("can be read or changed by others: chmod 600 " + path);
  return trimmed({bytes.data(), static_cast<std::size_t>(size)});
}

}  // namespace geminga::shell
