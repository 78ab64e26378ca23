// The cage that the daemon closes around itself before it hears the first stranger.
#ifndef GEMINGA_DAEMON_CAGE_IN_FORCE_HPP
#define GEMINGA_DAEMON_CAGE_IN_FORCE_HPP

#include <expected>
#include <string>

#include "daemon/configuration/configuration.hpp"
#include "daemon/log/log.hpp"
#include "env/cage/cage.hpp"

namespace geminga::daemon {

/// All that a daemon with this configuration needs once it listens, and whatever a later configuration may ask for
/// (README.md has the table).
[[nodiscard]] cage::Freedom freedom_to_serve(const Configuration& configuration);

class CageInForce {
 public:
  /// Closes the cage around this process, which has one thread, as the configuration wants it, and tells the log what
  /// holds. The error, a line for the user: the configuration requires what this kernel does not have.
  [[nodiscard]] std::expected<void, std::string> close(const Configuration& configuration, Log& log);
  /// The parts that hold, as `query status` has them: `calls,files`, one of them, or `none`.
  [[nodiscard]] std::string words() const;

 private:
  cage::Held held_;
};

}  // namespace geminga::daemon

#endif
