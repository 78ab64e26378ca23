// The log hook of a node: lines that say what it waits for and what was refused (src/client/CHANNELS.md, Nothing in
// silence).
#ifndef GEMINGA_CLIENT_CHANNELS_LOG_HPP
#define GEMINGA_CLIENT_CHANNELS_LOG_HPP

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "base/time.hpp"
#include "client/channels/reactor.hpp"
#include "client/protocol/session.hpp"

namespace geminga::client {

/// Gives lines to a function of the program; to standard error if there is none. Neither copies nor moves.
class Log {
 public:
  using Write = std::function<void(std::string_view line)>;
  /// The time after which a missing daemon is told.
  static constexpr std::chrono::seconds daemon_patience{1};

  Log(Reactor& reactor, Write write);

  void set(Write write) { write_ = std::move(write); }
  void line(std::string_view text) const;

  /// The daemon at this place was not reached, or is gone.
  void on_no_daemon(const std::string& where, const std::string& reason);
  void on_daemon(const std::string& where);
  /// The daemon has refused a request, for this reason.
  void on_refused(const Session::Stated& stated, const std::string& text) const;

 private:
  Reactor& reactor_;
  Write write_;
  std::string where_;
  std::string reason_;
  bool was_told_ = false;
  Reactor::Timer timer_;
};

}  // namespace geminga::client

#endif
