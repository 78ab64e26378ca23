// The conversation of a Client, whose calls wait: requests, answers, and the events that come meanwhile.
#ifndef GEMINGA_CLIENT_CPP_BLOCKING_SESSION_HPP
#define GEMINGA_CLIENT_CPP_BLOCKING_SESSION_HPP

#include <chrono>
#include <cstdint>
#include <deque>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "client/channels/daemon_connection.hpp"
#include "client/cpp/deadline.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/gcnp/statement.hpp"
#include "geminga/client.hpp"

namespace geminga::client {

/// After an error other than refused and wrong_use nothing can be sent, and every call gives that error again. Neither
/// copies nor moves. Not thread-safe.
class BlockingSession {
 public:
  explicit BlockingSession(std::chrono::milliseconds timeout) : timeout_(timeout) {}

  /// Connects to the first of these endpoints that listens. The timeout is for all of them.
  [[nodiscard]] std::expected<void, ClientError> connect(const std::vector<Endpoint>& endpoints);
  /// Sends `0 sys hello` and returns its answer.
  [[nodiscard]] std::expected<gcnp::Statement, ClientError> hello(const ClientOptions& options);
  /// Sends a request that is answered by silence or an error, and waits until it has been handled.
  [[nodiscard]] std::expected<void, ClientError> request(const gcnp::Statement& statement);
  /// Sends a query and returns the lines of its answer, the end line last.
  [[nodiscard]] std::expected<std::vector<gcnp::Statement>, ClientError> query(const gcnp::Statement& statement);
  /// The next event; nothing if none comes until the deadline.
  [[nodiscard]] std::expected<std::optional<Event>, ClientError> next_event(Clock::time_point deadline);

  /// A number that no request of this session has had.
  [[nodiscard]] std::uint32_t next_number();
  [[nodiscard]] int file_descriptor() const { return connection_ ? connection_->socket().get() : -1; }

 private:
  /// The answer that a call waits for.
  struct Wait {
    std::uint32_t id = 0;  ///< errors about this request, or about 0, are for this call
    std::string last;      ///< the message that ends the wait: hello, pong or end
    std::vector<gcnp::Statement> messages;
    std::optional<Error> error;
    bool is_over = false;
  };

  std::expected<void, ClientError> send(const gcnp::Statement& statement);
  /// Reads until the wait is over or the timeout.
  std::expected<void, ClientError> finish(Wait& wait);
  /// Reads once and takes every line that is complete. `wait` may be null.
  std::expected<void, ClientError> read_lines(Clock::time_point deadline, Wait* wait);
  std::expected<void, ClientError> take(gcnp::Reply reply, Wait* wait);
  ClientError broken(ClientError::Kind kind, std::string text);
  /// The daemon has closed the connection, or it has met an error.
  ClientError lost(int error);
  [[nodiscard]] ClientError no_answer() const;

  std::chrono::milliseconds timeout_;
  std::optional<DaemonConnection> connection_;
  std::string where_;  ///< the endpoint, for texts
  std::deque<Event> events_;
  std::uint32_t last_number_ = 0;
  bool was_met_ = false;
  std::optional<ClientError> broken_;
};

}  // namespace geminga::client

#endif
