// A channel as standard input or output, so that a service needs no code.
#ifndef GEMINGA_SHELL_PIPE_HPP
#define GEMINGA_SHELL_PIPE_HPP

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "geminga/node.hpp"
#include "shell/exit_status.hpp"

namespace geminga::shell {

/// The longest line of standard input that is one message, without its end.
inline constexpr std::size_t max_piped_bytes = std::size_t{16} * 1024 * 1024;

struct Pipe {
  std::string_view program;
  ClientOptions connection;
  /// How long altogether; nothing: without end.
  std::optional<std::chrono::milliseconds> timeout;
  /// Ends after so many messages; 0: never.
  std::uint64_t count = 0;
  /// Ends when the daemon goes, as it does where it is not there at first. Else channels go on, and it is looked for.
  bool is_kept = false;
};

/// Writes each message that comes for one of these to standard output, and a line end behind it, until a signal
/// (found), `count` messages (found), the timeout (found where a message came and no count was asked for, else
/// timed_out), or the daemon's end (no_daemon). Who comes and goes is told on standard error.
[[nodiscard]] ExitStatus listen(const Pipe& pipe, const std::vector<NamedSubscription>& subscriptions);

/// Sends each line of standard input, without its end, as one message; a line waits until somebody listens and has
/// room. Ends with its end (found, and the consumers have all of it), or as listen() does.
[[nodiscard]] ExitStatus send(const Pipe& pipe, const NamedPublication& publication);

}  // namespace geminga::shell

#endif
