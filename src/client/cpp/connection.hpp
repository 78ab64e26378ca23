// A connection whose calls wait at most until a deadline; the only place of the client that names Asio.
#ifndef GEMINGA_CLIENT_CPP_CONNECTION_HPP
#define GEMINGA_CLIENT_CPP_CONNECTION_HPP

#include <chrono>
#include <cstddef>
#include <expected>
#include <memory>
#include <string>
#include <string_view>

#include "client/channels/daemon_endpoint.hpp"

namespace geminga::client {

using Clock = std::chrono::steady_clock;

/// Neither copies nor moves. Not thread-safe.
class Connection {
 public:
  enum class Failure {
    bad_address,  ///< the address is not one in numbers, or the path is too long
    unreachable,  ///< the system's reason is in reason()
    timed_out,    ///< the deadline came first; a write may have been done in part
    closed,       ///< by the other side, or by an error of the connection
  };

  Connection();
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Connects, once.
  [[nodiscard]] std::expected<void, Failure> connect(const Endpoint& endpoint, Clock::time_point deadline);
  /// Writes all of the bytes.
  [[nodiscard]] std::expected<void, Failure> write(std::string_view bytes, Clock::time_point deadline);
  /// Some bytes, at least one; a deadline that has passed still gives what is there.
  [[nodiscard]] std::expected<std::string_view, Failure> read(Clock::time_point deadline);

  /// Why the last call failed, in the system's words.
  [[nodiscard]] const std::string& reason() const;
  [[nodiscard]] int file_descriptor() const;

 private:
  class Socket;
  std::unique_ptr<Socket> socket_;
};

}  // namespace geminga::client

#endif
