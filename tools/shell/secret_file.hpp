// A file with a secret: a token, a password.
#ifndef GEMINGA_SHELL_SECRET_FILE_HPP
#define GEMINGA_SHELL_SECRET_FILE_HPP

#include <cstddef>
#include <expected>
#include <string>

namespace geminga::shell {

/// The octets of such a file that are read; the rest is left out.
inline constexpr std::size_t max_secret_file_octets = 1024;

/// Reads a secret: the whole file but blanks and line ends around it. The error is one line without the secret: a file
/// that cannot be read, or that its group or others may read or change (in $CREDENTIALS_DIRECTORY its group may read
/// it, systemd.exec(5)).
[[nodiscard]] std::expected<std::string, std::string> read_secret(const std::string& path);

}  // namespace geminga::shell

#endif
