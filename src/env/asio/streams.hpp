// The clients that came in by the doors: what they say, what is said to them, and how they end.
#ifndef GEMINGA_ENV_ASIO_STREAMS_HPP
#define GEMINGA_ENV_ASIO_STREAMS_HPP

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstddef>
#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "env/asio/doors.hpp"
#include "env/asio/endpoint.hpp"
#include "env/env.hpp"

namespace geminga::env {

/// Connections at once, those that are being closed included, which give way; one more is closed unheard. The
/// participant has a smaller limit and says so in GCNP; this one bounds sockets.
inline constexpr std::size_t max_connections = 192;
/// Memory that waits for one client. The participant stops long before it (participant/settings.hpp); who has more to
/// read is closed.
inline constexpr std::size_t max_queued_bytes = 8 * 1024 * 1024;
/// The same for all clients together. Beyond it the one that holds the most is closed.
inline constexpr std::size_t max_queued_bytes_in_all = 64 * 1024 * 1024;
/// Octets read from a client in one turn of the event loop.
inline constexpr std::size_t read_chunk_bytes = 16 * 1024;
/// What a closed client may still send before the socket is closed hard; it lets our last words arrive.
inline constexpr std::size_t max_lingering_bytes = 4 * 1024 * 1024;
/// How long a closed client may take to read our last words.
inline constexpr std::chrono::seconds linger_time{2};

/// Accepts and serves. Not thread-safe; its functions never call back, handlers do.
class Streams {
 public:
  /// Where what happens is told: each call is one event.
  struct Handlers {
    std::function<void(StreamId, const std::string& user)> opened;
    std::function<void(StreamId, std::string_view)> bytes;
    std::function<void(StreamId)> drained;
    std::function<void(StreamId)> closed;
  };

  Streams(boost::asio::io_context& context, Handlers handlers);
  ~Streams();
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;

  /// Binds and listens; clients wait in the backlog until serve().
  [[nodiscard]] std::expected<void, ListenError> listen(const Endpoint& endpoint);
  [[nodiscard]] std::expected<void, std::string> listen(const std::string& path);
  void serve();
  /// Accepts nobody any more.
  void stop_listening();

  /// Queues; sent by flush().
  void write(StreamId stream, std::string_view bytes);
  [[nodiscard]] std::size_t unsent(StreamId stream) const;
  void want(StreamId stream, bool is_wanted);
  void close(StreamId stream);
  /// Hands what was queued to the kernel. To be called at the end of every event.
  void flush();

  /// Whether some client has not been given all its bytes yet.
  [[nodiscard]] bool is_writing() const;

 private:
  class State;
  std::shared_ptr<State> state_;
};

}  // namespace geminga::env

#endif
