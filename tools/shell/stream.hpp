// A client whose events are printed until a signal, a time, a count or the daemon's end.
#ifndef GEMINGA_SHELL_STREAM_HPP
#define GEMINGA_SHELL_STREAM_HPP

#include <chrono>
#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <string_view>

#include "geminga/client.hpp"
#include "geminga/event.hpp"
#include "shell/exit_status.hpp"
#include "shell/stop_signals.hpp"

namespace geminga::shell {

struct Stream {
  std::string_view program;
  ClientOptions connection;
  /// States what is offered or asked for, on a fresh connection.
  std::function<std::expected<void, ClientError>(Client&)> begin;
  /// Prints one event; returns whether it counts.
  std::function<bool(const Event&)> print;
  /// How long altogether; nothing: without end.
  std::optional<std::chrono::milliseconds> timeout;
  /// Ends after this many events; 0: never.
  std::uint64_t count = 0;
  /// Connects again, and again, when the daemon goes.
  bool is_kept = false;
};

/// Runs until a signal (found), `count` events (found), the timeout (found where an event came and no count was asked
/// for, else timed_out) or the daemon's end (no_daemon, unless it is kept). What is refused ends it.
[[nodiscard]] ExitStatus run(const Stream& stream);

}  // namespace geminga::shell

#endif
