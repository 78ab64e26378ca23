// Prints the events of a client until a signal, a time, a count or the daemon's end.
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

namespace geminga::shell {

/// Shows events to a reader, and remembers which services or requests are there.
class EventView {
 public:
  virtual ~EventView() = default;
  /// Shows one event. Returns whether it counts.
  virtual bool tell(const Event& event) = 0;
  /// Doubts everything until it is shown again, because the daemon went.
  virtual void doubt() = 0;
  /// Shows one service or request in doubt as gone; false where there is none.
  virtual bool drop_doubted() = 0;
};

struct Stream {
  std::string_view program;
  ClientOptions connection;
  /// Offers and asks on a fresh connection.
  std::function<std::expected<void, ClientError>(Client&)> begin;
  /// The most time altogether; nothing: no limit.
  std::optional<std::chrono::milliseconds> timeout;
  /// The events after which it ends; 0: it goes on.
  std::uint64_t count = 0;
  /// Connects again when the daemon goes. Services and requests that the daemon then does not report again are shown as
  /// gone.
  bool is_kept = false;
  /// The queue to which the view gives its events; borrowed, null: none. Events are taken while it has room.
  CommandQueue* commands = nullptr;
};

/// Runs until a signal (found), `count` events (found), the timeout (found where an event came and no count was asked
/// for, else timed_out), the daemon's end (no_daemon, unless it is kept) or a refusal. A signal and the timeout
/// withdraw all statements and stop the commands; else the commands of all events run first.
[[nodiscard]] ExitStatus run(const Stream& stream, EventView& view);

}  // namespace geminga::shell

#endif
