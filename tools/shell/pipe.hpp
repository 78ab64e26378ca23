// A channel of messages as standard input or output, so that a service needs no code.
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

/// The most octets of a line of standard input, without its end. A line is one message.
inline constexpr std::size_t max_piped_bytes = std::size_t{16} * 1024 * 1024;

struct Pipe {
  std::string_view program;
  ClientOptions connection;
  /// The most time altogether; nothing: no limit.
  std::optional<std::chrono::milliseconds> timeout;
  /// The messages after which it ends; 0: it goes on.
  std::uint64_t count = 0;
  /// With false, ends when the daemon goes or is not there at first. With true, channels go on, and the program
  /// connects again.
  bool is_kept = false;
};

/// Writes each message for one of these subscriptions to standard output as a line. Ends at a signal (found), after
/// `count` messages (found), at the timeout (found where a message came and no count was asked for, else timed_out), or
/// with the daemon (no_daemon). Says on standard error which peers come and go.
[[nodiscard]] ExitStatus listen(const Pipe& pipe, const std::vector<NamedSubscription>& subscriptions);

/// Sends each line of standard input, without its end, as one message. A line waits until a consumer has room. Ends
/// with standard input (found, and the consumers have all messages), or as listen() does.
[[nodiscard]] ExitStatus send(const Pipe& pipe, const NamedPublication& publication);

}  // namespace geminga::shell

#endif
