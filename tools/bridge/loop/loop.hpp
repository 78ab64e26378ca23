// The loop of a bridge's program: the daemon, the timers and the signals, on one thread.
#ifndef GEMINGA_BRIDGE_LOOP_LOOP_HPP
#define GEMINGA_BRIDGE_LOOP_LOOP_HPP

#include <optional>
#include <string>
#include <string_view>

#include "bridge/team/team.hpp"
#include "client/channels/reactor.hpp"
#include "shell/options.hpp"
#include "shell/stop_signals.hpp"

namespace geminga::bridge {

/// Made before any thread. Neither copies nor moves.
class Loop {
 public:
  /// `program` is the name by which the program complains and is known to the daemon.
  Loop(std::string_view program, const shell::CommonOptions& options);

  /// Whether the address of the daemon could be read; else it has complained.
  [[nodiscard]] bool is_ready() const { return team_.has_value(); }
  [[nodiscard]] client::Reactor& reactor() { return reactor_; }
  /// Requires is_ready().
  [[nodiscard]] Team& team() { return *team_; }

  /// Serves until a signal, then withdraws everything. Returns the exit status. Requires is_ready().
  [[nodiscard]] int run();

 private:
  shell::StopSignals signals_;
  client::Reactor reactor_;
  std::optional<Team> team_;
};

}  // namespace geminga::bridge

#endif
