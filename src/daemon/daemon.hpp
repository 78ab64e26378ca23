// gemingad as a whole: one participant in the real world, its ontologies, and the signals that steer it.
#ifndef GEMINGA_DAEMON_DAEMON_HPP
#define GEMINGA_DAEMON_DAEMON_HPP

#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "daemon/configuration.hpp"
#include "daemon/log.hpp"

namespace geminga::daemon {

/// Exit statuses of the contract.
inline constexpr int exit_done = 0;
inline constexpr int exit_wrong = 2;

class Daemon {
 public:
  /// Reads the configuration again, for SIGHUP.
  using Reread = std::function<std::expected<Configuration, std::vector<std::string>>()>;

  Daemon(Configuration configuration, Reread reread, Log& log);
  ~Daemon();
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  /// Loads the ontologies and nothing more. The errors are lines for the user.
  [[nodiscard]] std::expected<void, std::vector<std::string>> check();
  /// Serves until SIGTERM or SIGINT. The errors are why it could not begin, lines for the user.
  [[nodiscard]] std::expected<void, std::vector<std::string>> run();
  /// Whether a thread is still at work. It cannot be stopped, so the process must not destroy what the thread uses.
  [[nodiscard]] bool is_at_work() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace geminga::daemon

#endif
