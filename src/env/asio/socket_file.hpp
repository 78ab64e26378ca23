// The file by which a Unix socket is found: made for one daemon, and removed by no other.
#ifndef GEMINGA_ENV_ASIO_SOCKET_FILE_HPP
#define GEMINGA_ENV_ASIO_SOCKET_FILE_HPP

#include <sys/types.h>

#include <cstddef>
#include <expected>
#include <string>

namespace geminga::env {

/// The longest path of a Unix socket: sockaddr_un has room for it and the zero behind it (unix(7)).
inline constexpr std::size_t max_socket_path_bytes = 107;

/// A listening Unix socket at a path, for the daemon's user and group (mode 0660). It can be moved. Its destructor
/// removes the file if that is still the one that was made.
class SocketFile {
 public:
  /// Binds and listens. A socket that nobody listens on was left by a dead daemon and is replaced. One that a process
  /// listens on is not replaced, and nothing else is ever removed. The error is one line that says what to do.
  [[nodiscard]] static std::expected<SocketFile, std::string> make(const std::string& path);
  ~SocketFile();
  SocketFile(SocketFile&& other) noexcept;
  SocketFile& operator=(SocketFile&&) = delete;

  /// Gives the listening socket to the caller, who owns it then.
  [[nodiscard]] int take_descriptor();

 private:
  SocketFile(std::string path, int descriptor, dev_t device, ino_t inode)
      : path_(std::move(path)), descriptor_(descriptor), device_(device), inode_(inode) {}

  std::string path_;  ///< empty: it was moved away
  int descriptor_ = -1;
  dev_t device_;
  ino_t inode_;
};

/// The user at the other end of a connected Unix socket: the name in /etc/passwd, else the number; empty for any other
/// socket. Reads only that file and asks no name service, which could block.
[[nodiscard]] std::string user_of(int socket);

}  // namespace geminga::env

#endif
