// A client whose events are told until a signal, a time, a count or the daemon's end.
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
#include "shell/command_queue.hpp"
#include "shell/exit_status.hpp"
#include "shell/stop_signals.hpp"

namespace geminga::shell {

/// Tells a reader of events and keeps in mind what is there.
class EventView {
 public:
  virtual ~EventView() = default;
  /// Tells one event; returns whether it counts.
  virtual bool tell(const Event& event) = 0;
  /// The daemon that knew it all went: what was told is in doubt until it is told again.
  virtual void doubt() = 0;
  /// Tells of one thing in doubt that it is gone; false where there is none.
  virtual bool drop_doubted() = 0;
};

struct Stream {
  std::string_view program;
  ClientOptions connection;
  /// States what is offered or asked for, on a fresh connection.
  std::function<std::expected<void, ClientError>(Client&)> begin;
  /// How long altogether; nothing: without end.
  std::optional<std::chrono::milliseconds> timeout;
  /// Ends after this many events; 0: never.
  std::uint64_t count = 0;
  /// Connects again, and again, when the daemon goes. Once everything is stated again, what was told before and not
  /// again is dropped.
  bool is_kept = false;
  /// Where the view gives its events to; borrowed, null: nowhere. Events are taken while it has room.
  CommandQueue* commands = nullptr;
};

/// Runs until a signal (found), `count` events (found), the timeout (found where an event came and no count was asked
/// for, else timed_out) or the daemon's end (no_daemon, unless it is kept). What is refused ends it. A signal and the
/// timeout withdraw what was stated and stop the commands; else those of all events are run first.
[[nodiscard]] ExitStatus run(const Stream& stream, EventView& view);

}  // namespace geminga::shell

#endif
