// Signs of life for the supervisor's watchdog.
#ifndef GEMINGA_DAEMON_SUPERVISOR_WATCHDOG_HPP
#define GEMINGA_DAEMON_SUPERVISOR_WATCHDOG_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include "daemon/supervisor/supervisor.hpp"

namespace geminga::daemon {

/// Gives them from the turns of the event loop, twice in the time that the supervisor asks for: a loop that hangs gives
/// none, and the supervisor ends the process.
class Watchdog {
 public:
  /// Borrows both for its life.
  Watchdog(boost::asio::io_context& context, const Supervisor& supervisor) : supervisor_(supervisor), timer_(context) {}
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// Begins, where the supervisor wants signs of life.
  void start();

 private:
  const Supervisor& supervisor_;
  boost::asio::steady_timer timer_;
};

}  // namespace geminga::daemon

#endif
