// The connected clients: their input, their output, and how they end.
#ifndef GEMINGA_ENV_ASIO_STREAMS_HPP
#define GEMINGA_ENV_ASIO_STREAMS_HPP

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstddef>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "env/asio/doors.hpp"
#include "env/asio/endpoint.hpp"
#include "env/env.hpp"

namespace geminga::env {

/// The most connections at once. Those that are being closed count, and give way; a further one is closed unheard. The
/// participant has a smaller limit and says so in GCNP; this one bounds sockets.
inline constexpr std::size_t max_connections = 192;
/// The most memory that waits for one client. The participant stops long before it (participant/clients/limits.hpp); a
/// client for which more waits is closed.
inline constexpr std::size_t max_queued_bytes = 8 * 1024 * 1024;
/// The same for all clients together. Beyond it the client that holds the most is closed.
inline constexpr std::size_t max_queued_bytes_in_all = 64 * 1024 * 1024;
/// Octets read from a client in one turn of the event loop.
inline constexpr std::size_t read_chunk_bytes = 16 * 1024;
/// The octets that a closed client may still send before the socket is closed hard. They let our last lines arrive.
inline constexpr std::size_t max_lingering_bytes = 4 * 1024 * 1024;
/// The time that a closed client may take to read our last lines.
inline constexpr std::chrono::seconds linger_time{2};

/// Accepts clients and serves them. Not thread-safe. Its functions never call back; its handlers do. The handlers that
/// wait on sockets hold it, so its owner calls shut_down() at the end.
class Streams : public std::enable_shared_from_this<Streams> {
 public:
  /// The receivers of events: each call is one event.
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

  /// Binds and listens. Clients wait in the backlog until serve().
  [[nodiscard]] std::expected<void, ListenError> listen(const Endpoint& endpoint) { return doors_->listen(endpoint); }
  [[nodiscard]] std::expected<void, std::string> listen(const std::string& path) { return doors_->listen(path); }
  /// Accepts on a socket that a supervisor has made (Doors::adopt()).
  [[nodiscard]] std::expected<std::string, std::string> adopt(int descriptor) { return doors_->adopt(descriptor); }
  void serve();
  /// Stops accepting.
  void stop_listening() { doors_->close(); }
  /// Closes everything; no handler is called from then on.
  void shut_down();

  /// Queues bytes, which flush() sends.
  void write(StreamId stream, std::string_view bytes);
  [[nodiscard]] std::size_t unsent(StreamId stream) const;
  void want(StreamId stream, bool is_wanted);
  void close(StreamId stream);
  /// Hands what was queued to the kernel. Call at the end of every event.
  void flush();

  /// Whether a client has not been given all its bytes yet.
  [[nodiscard]] bool is_writing() const;

 private:
  struct Connection;
  using Pointer = std::shared_ptr<Connection>;

  void take(Doors::Socket socket);
  /// Drops a connection that is closed already and only takes its last lines, in favour of a new one.
  bool drop_oldest_closed();
  void mark(const Pointer& connection);
  /// Hands the queue to the kernel, as far as it takes it.
  void send(Connection& connection);
  /// Changes a queue, and counts what all queues hold.
  template <typename Action>
  void change_queue(Connection& connection, Action&& action);
  void append(Connection& connection, std::string_view bytes);
  void forget_queue(Connection& connection);
  /// Sends, and waits for what the connection needs next. Only this function decides that.
  void proceed(const Pointer& connection);
  /// Tells it in an event of its own, since the current one may be the end of another.
  void tell_drained(StreamId id);
  void await_writable(const Pointer& connection);
  void await_readable(const Pointer& connection);
  void read(const Pointer& connection);
  /// Ends a client that has closed its side: it has withdrawn everything, and still gets what was queued for it.
  void end(const Pointer& connection);
  /// Loses a client that reads too slowly: it is closed hard, and the participant is told in an event of its own.
  void lose(Pointer connection);
  /// Closes the client that holds the most, not the one that comes next.
  void lose_greediest();
  void start_lingering(const Pointer& connection);
  void drop(Pointer connection);

  boost::asio::io_context& context_;
  Handlers handlers_;
  std::shared_ptr<Doors> doors_;
  std::map<StreamId, Pointer> connections_;
  std::vector<Pointer> dirty_;
  std::uint64_t last_id_ = 0;
  std::size_t held_ = 0;  ///< by all queues
  bool is_down_ = false;
};

}  // namespace geminga::env

#endif
