// Unix sockets for notices: datagrams to a service of this host that are never waited for.
#ifndef GEMINGA_DAEMON_SUPERVISOR_NOTICE_SOCKET_HPP
#define GEMINGA_DAEMON_SUPERVISOR_NOTICE_SOCKET_HPP

#include <string_view>

namespace geminga::daemon {

/// A socket that sends to this path, or, where it begins with '@', to this abstract name. -1 where that is not
/// possible. The caller closes it.
[[nodiscard]] int connect_for_notices(std::string_view path);

/// Sends one notice. False: it was not sent, since there is no room or nobody there.
bool send_notice(int socket, std::string_view notice);

}  // namespace geminga::daemon

#endif
