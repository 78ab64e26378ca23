#include "env/asio/socket_file.hpp"

#include <fcntl.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "env/asio/descriptor.hpp"

namespace geminga::env {
namespace {

constexpr mode_t socket_mode = 0660;

std::string system_words() { return std::generic_category().message(errno); }

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.data(), path.size());
  return address;
}

int new_socket() { return ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0); }

/// Whether no process listens on the socket. Every answer but a clear no counts as a process.
bool is_abandoned(const sockaddr_un& address) {
  const Descriptor probe(new_socket());
  if (probe.get() < 0) return false;
  return ::connect(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
         errno == ECONNREFUSED;
}

/// Makes room at the path. The error says why that must not be.
std::optional<std::string> clear_path(const std::string& path, const sockaddr_un& address, const std::string& shown) {
  struct stat there{};
  if (::lstat(path.c_str(), &there) != 0) {
    if (errno == ENOENT) return std::nullopt;
    return "cannot listen on " + shown + ": " + system_words();
  }
  if (!S_ISSOCK(there.st_mode)) return shown + " is there and is no socket: choose another path with --gcnp-socket";
  if (!is_abandoned(address)) {
    return shown + " is already in use: another gemingad? choose another with --gcnp-socket";
  }
  if (::unlink(path.c_str()) != 0) return "cannot replace the left-over " + shown + ": " + system_words();
  return std::nullopt;
}

/// Binds so that the file has its mode from its first moment: the mode is the socket's own, which the mask must not
/// cut.
bool bind_with_mode(int socket, const sockaddr_un& address) {
  if (::fchmod(socket, socket_mode) != 0) return false;
  const mode_t mask = ::umask(0);
  const bool is_bound = ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int error = errno;
  ::umask(mask);
  errno = error;
  return is_bound;
}

}  // namespace

std::expected<SocketFile, std::string> SocketFile::make(const std::string& path) {
  const std::string shown = base::printable(path, 200);
  if (path.empty() || path.size() > max_socket_path_bytes || path.find('\0') != std::string::npos) {
    return std::unexpected(shown + " is no path of a socket: use 1 to " + std::to_string(max_socket_path_bytes) +
                           " octets");
  }
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  // Two daemons that start at once must not each remove what the other has just made.
  const Descriptor folder(::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0) return std::unexpected("cannot listen on " + shown + ": " + system_words());
  if (::flock(folder.get(), LOCK_EX | LOCK_NB) != 0) {
    return std::unexpected("cannot listen on " + shown + ": its folder is locked: is another gemingad starting?");
  }
  const sockaddr_un address = address_of(path);
  if (auto error = clear_path(path, address, shown)) return std::unexpected(std::move(*error));
  Descriptor socket(new_socket());
  if (socket.get() < 0 || !bind_with_mode(socket.get(), address)) {
    return std::unexpected("cannot listen on " + shown + ": " + system_words());
  }
  struct stat made{};
  if (::lstat(path.c_str(), &made) != 0 || ::listen(socket.get(), SOMAXCONN) != 0) {
    const std::string words = system_words();
    ::unlink(path.c_str());
    return std::unexpected("cannot listen on " + shown + ": " + words);
  }
  return SocketFile(path, socket.release(), made.st_dev, made.st_ino);
}

SocketFile::SocketFile(SocketFile&& other) noexcept
    : path_(std::exchange(other.path_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      device_(other.device_),
      inode_(other.inode_) {}

SocketFile::~SocketFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (path_.empty()) return;
  struct stat there{};
  const bool is_ours = ::lstat(path_.c_str(), &there) == 0 && there.st_dev == device_ && there.st_ino == inode_;
  if (is_ours) ::unlink(path_.c_str());
}

int SocketFile::take_descriptor() { return std::exchange(descriptor_, -1); }

std::string user_of(int socket) {
  ucred credentials{};
  socklen_t length = sizeof credentials;
  sockaddr_storage own{};
  socklen_t own_length = sizeof own;
  if (::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &own_length) != 0 || own.ss_family != AF_UNIX) return "";
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &credentials, &length) != 0) return "";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen("/etc/passwd", "re"), &std::fclose);
  while (const passwd* one = file ? ::fgetpwent(file.get()) : nullptr) {
    if (one->pw_uid == credentials.uid) return base::printable(one->pw_name);
  }
  return std::to_string(credentials.uid);
}

}  // namespace geminga::env
