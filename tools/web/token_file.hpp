// The file of the secret that readers bring.
#ifndef GEMINGA_WEB_TOKEN_FILE_HPP
#define GEMINGA_WEB_TOKEN_FILE_HPP

#include <expected>
#include <string>

namespace geminga::web {

/// Reads the token: the whole file but blanks and line ends around it. The error is one line without the token: a file
/// that cannot be read, that its group or others may read or change (in $CREDENTIALS_DIRECTORY its group may read it,
/// systemd.exec(5)), or that holds no token.
[[nodiscard]] std::expected<std::string, std::string> read_token(const std::string& path);

}  // namespace geminga::web

#endif
