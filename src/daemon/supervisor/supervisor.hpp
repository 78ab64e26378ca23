// The supervisor that started the daemon, usually systemd: what it gives, and what it is told.
#ifndef GEMINGA_DAEMON_SUPERVISOR_SUPERVISOR_HPP
#define GEMINGA_DAEMON_SUPERVISOR_SUPERVISOR_HPP

#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

#include "base/time.hpp"

namespace geminga::daemon {

/// Speaks the protocols of sd_notify(3), sd_watchdog_enabled(3) and sd_listen_fds(3), which their manual pages define
/// for programs without libsystemd. The socket is connected in the constructor, before the daemon closes its cage;
/// libsystemd would open one for each notice. Without a supervisor every function does nothing.
class Supervisor {
 public:
  /// Reads $NOTIFY_SOCKET, $WATCHDOG_USEC, $WATCHDOG_PID, $LISTEN_FDS and $LISTEN_PID. `environment` is as main() gets
  /// it.
  explicit Supervisor(const char* const* environment);
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// The listening sockets that were given to this process; they are marked to be closed in its children. At most
  /// `max_given_sockets`.
  [[nodiscard]] const std::vector<int>& sockets() const { return sockets_; }
  /// The time within which the supervisor wants a sign of life; nothing where it wants none.
  [[nodiscard]] std::optional<std::chrono::microseconds> watchdog() const { return watchdog_; }

  /// The daemon serves; also the end of a reload. `status` is one line for the user.
  void say_ready(std::string_view status) const;
  /// A reload begins at `now`, by the monotonic clock.
  void say_reloading(base::Instant now) const;
  void say_stopping() const;
  /// A sign of life for the watchdog.
  void say_alive() const;

 private:
  int socket_ = -1;  ///< -1: nobody wants notices
  std::optional<std::chrono::microseconds> watchdog_;
  std::vector<int> sockets_;
};

/// The most sockets that a supervisor may give.
inline constexpr int max_given_sockets = 16;

}  // namespace geminga::daemon

#endif
