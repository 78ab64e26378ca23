// The word that the daemon is ready, after its start and after each reload.
#ifndef GEMINGA_DAEMON_READINESS_HPP
#define GEMINGA_DAEMON_READINESS_HPP

#include <functional>
#include <string>

#include "base/log.hpp"
#include "base/time.hpp"
#include "daemon/supervisor/supervisor.hpp"

namespace geminga::daemon {

/// Tells the log once, and the supervisor at the end of the start and of each reload that it was told of.
class Readiness {
 public:
  /// `line` says what is served, for people. Borrows supervisor and log for its life.
  Readiness(const Supervisor& supervisor, base::LogSink& log, std::function<std::string()> line);

  /// A reload begins at `now`, by the monotonic clock.
  void begin_reload(base::Instant now);
  /// Takes in whether the participant is ready, and whether an ontology is still being loaded. Call after each event.
  void update(bool is_ready, bool is_loading);

 private:
  const Supervisor& supervisor_;
  base::LogSink& log_;
  std::function<std::string()> line_;
  bool is_told_ = false;
  bool is_reloading_ = false;
};

}  // namespace geminga::daemon

#endif
