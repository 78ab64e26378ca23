#include "daemon/supervisor/watchdog.hpp"

namespace geminga::daemon {

void Watchdog::start() {
  const auto time = supervisor_.watchdog();
  if (!time) return;
  supervisor_.say_alive();
  timer_.expires_after(*time / 2);
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (!error) start();
  });
}

}  // namespace geminga::daemon
