#include "daemon/supervisor/notice_socket.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>

namespace geminga::daemon {

int connect_for_notices(std::string_view path) {
  sockaddr_un address{};
  if (path.size() < 2 || path.size() >= sizeof(address.sun_path)) return -1;
  if (path.front() != '/' && path.front() != '@') return -1;
  address.sun_family = AF_UNIX;
  std::ranges::copy(path, address.sun_path);
  const bool is_abstract = path.front() == '@';
  if (is_abstract) address.sun_path[0] = '\0';
  // An abstract name is as long as it is; a path has a zero behind it (unix(7)).
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size() + (is_abstract ? 0 : 1));
  const int descriptor = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return -1;
  if (::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), size) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

bool send_notice(int socket, std::string_view notice) {
  ssize_t sent = 0;
  do {
    sent = ::send(socket, notice.data(), notice.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent >= 0;
}

}  // namespace geminga::daemon
