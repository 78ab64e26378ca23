// One connection to a daemon: statements out, replies in, and no call waits.
#ifndef GEMINGA_CLIENT_CHANNELS_DAEMON_CONNECTION_HPP
#define GEMINGA_CLIENT_CHANNELS_DAEMON_CONNECTION_HPP

#include <expected>
#include <optional>
#include <string>

#include "client/channels/endpoint.hpp"
#include "client/channels/socket.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/gcnp/line_reader.hpp"
#include "discovery/gcnp/statement.hpp"

namespace geminga::client {

/// The connection of DaemonLink, which a reactor drives, and of BlockingSession, which waits by poll(2). Errors are the
/// system's numbers. Moves and does not copy. Not thread-safe.
class DaemonConnection {
 public:
  /// Begins to connect. The socket becomes writable when that has succeeded or failed; pending_error() says which.
  /// Errors: EINVAL where the address is not numeric, ENAMETOOLONG for a path, and those of connect(2).
  [[nodiscard]] static std::expected<DaemonConnection, int> open(const Endpoint& endpoint);

  [[nodiscard]] const Socket& socket() const { return socket_; }

  /// Appends a line to what waits to be written.
  void put(const gcnp::Statement& statement) { unwritten_ += gcnp::to_line(statement); }
  [[nodiscard]] bool has_unwritten() const { return !unwritten_.empty(); }
  /// Writes what the system takes now. After an error nothing waits any more.
  [[nodiscard]] std::expected<void, int> write();
  /// Closes the half that writes.
  void finish();

  /// Reads once what has come; next() gives it. Errors: EAGAIN where nothing has come, 0 where the daemon has closed.
  [[nodiscard]] std::expected<void, int> read();
  /// The next reply of what was read; nothing until more is read. The error is a line that is not GCNP.
  [[nodiscard]] std::optional<std::expected<gcnp::Reply, Error>> next();

 private:
  explicit DaemonConnection(Socket socket) : socket_(std::move(socket)) {}

  Socket socket_;
  std::string unwritten_;
  gcnp::LineReader reader_;
};

/// The statement that opens a conversation. `name` may be empty; `room` is that of ClientOptions, 0 for none; only a
/// client with channels asks for their keys.
[[nodiscard]] gcnp::Statement hello_statement(const std::string& name, std::uint32_t room, bool asks_for_keys = false);
/// The text for an endpoint where something else than a daemon answers.
[[nodiscard]] std::string no_daemon_text(const std::string& where, const Error& error);
/// The system's words for an error number.
[[nodiscard]] std::string system_text(int number);

}  // namespace geminga::client

#endif
