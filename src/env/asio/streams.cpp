#include "env/asio/streams.hpp"

#include <sys/socket.h>

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <map>

namespace geminga::env {
namespace {

namespace net = boost::asio;
using net::ip::tcp;

/// How long accepting pauses when the process has no descriptor left.
constexpr std::chrono::milliseconds accept_pause{100};

struct Connection {
  Connection(StreamId number, tcp::socket accepted)
      : id(number), socket(std::move(accepted)), linger(socket.get_executor()) {}

  StreamId id;
  tcp::socket socket;
  net::steady_timer linger;
  std::string queue;
  std::size_t sent = 0;       // of the queue
  std::size_t lingering = 0;  // octets thrown away since it was closed
  bool is_open = true;        // the participant knows it
  bool is_dirty = false;      // waits for flush()
  bool is_reading = false;    // a wait for readability is under way
  bool is_writing = false;    // a wait for writability is under way
  bool is_shut = false;       // our side has said all
  bool has_ended = false;     // its side has said all

  [[nodiscard]] std::size_t waiting() const { return queue.size() - sent; }
};

ListenError listen_error(const boost::system::error_code& error) {
  auto kind = ListenError::Kind::other;
  if (error == net::error::address_in_use) kind = ListenError::Kind::in_use;
  if (error == boost::system::errc::address_not_available || error == net::error::address_family_not_supported) {
    kind = ListenError::Kind::not_available;
  }
  return {kind, error.message()};
}

}  // namespace

class Streams::State : public std::enable_shared_from_this<Streams::State> {
 public:
  State(net::io_context& context, Handlers handlers) : context_(context), handlers_(std::move(handlers)) {}

  std::expected<void, ListenError> listen(const Endpoint& endpoint) {
    tcp::acceptor acceptor(context_);
    boost::system::error_code error;
    const auto address = net::ip::make_address(endpoint.address, error);
    if (!error) acceptor.open(address.is_v4() ? tcp::v4() : tcp::v6(), error);
    if (!error) acceptor.set_option(net::socket_base::reuse_address(true), error);
    if (!error && address.is_v6()) acceptor.set_option(net::ip::v6_only(true), error);
    if (!error) acceptor.bind({address, endpoint.port}, error);
    if (!error) acceptor.listen(net::socket_base::max_listen_connections, error);
    if (error) return std::unexpected(listen_error(error));
    doors_.push_back({std::move(acceptor), net::steady_timer(context_)});
    return {};
  }

  void serve() {
    for (std::size_t number = 0; number < doors_.size(); ++number) accept(number);
  }

  void stop_listening() {
    boost::system::error_code ignored;
    for (Door& door : doors_) {
      door.acceptor.close(ignored);
      door.retry.cancel();
    }
  }

  void shut_down() {
    is_down_ = true;
    stop_listening();
    boost::system::error_code ignored;
    for (auto& [id, connection] : connections_) {
      connection->socket.close(ignored);
      connection->linger.cancel();
    }
    connections_.clear();
  }

  void write(StreamId stream, std::string_view bytes) {
    const auto found = connections_.find(stream);
    if (found == connections_.end() || !found->second->is_open) return;
    Connection& connection = *found->second;
    connection.queue.append(bytes);
    queued_ += bytes.size();
    mark(found->second);
    if (connection.waiting() <= max_queued_bytes && queued_ <= max_queued_bytes_in_all) return;
    send(connection);  // the kernel may have room for what this event has written
    if (connection.waiting() > max_queued_bytes || queued_ > max_queued_bytes_in_all) lose(found->second);
  }

  void close(StreamId stream) {
    const auto found = connections_.find(stream);
    if (found == connections_.end() || !found->second->is_open) return;
    found->second->is_open = false;
    start_lingering(found->second);
    mark(found->second);
  }

  void flush() {
    std::vector<std::shared_ptr<Connection>> dirty;
    dirty.swap(dirty_);
    for (const auto& connection : dirty) {
      connection->is_dirty = false;
      proceed(connection);
    }
  }

  [[nodiscard]] std::size_t connection_count() const { return connections_.size(); }
  [[nodiscard]] bool is_writing() const { return queued_ > 0; }

 private:
  using Pointer = std::shared_ptr<Connection>;
  struct Door {
    tcp::acceptor acceptor;
    net::steady_timer retry;
  };

  void accept(std::size_t number) {
    doors_[number].acceptor.async_accept(
        [self = shared_from_this(), number](const boost::system::error_code& error, tcp::socket socket) {
          if (self->is_down_ || !self->doors_[number].acceptor.is_open()) return;
          if (!error) self->take(std::move(socket));
          if (error && error != net::error::connection_aborted) return self->accept_later(number);
          self->accept(number);
        });
  }

  /// No descriptor is left: trying again at once would only spin.
  void accept_later(std::size_t number) {
    doors_[number].retry.expires_after(accept_pause);
    doors_[number].retry.async_wait([self = shared_from_this(), number](const boost::system::error_code& error) {
      if (!error && self->doors_[number].acceptor.is_open()) self->accept(number);
    });
  }

  void take(tcp::socket socket) {
    boost::system::error_code error;
    if (connections_.size() >= max_connections) {
      socket.close(error);
      return;
    }
    socket.set_option(tcp::no_delay(true), error);
    const StreamId id{++last_id_};
    const auto connection = std::make_shared<Connection>(id, std::move(socket));
    connections_.emplace(id, connection);
    handlers_.opened(id);
    proceed(connection);
  }

  void mark(const Pointer& connection) {
    if (connection->is_dirty) return;
    connection->is_dirty = true;
    dirty_.push_back(connection);
  }

  /// Hands what is queued to the kernel, as far as it takes it.
  void send(Connection& connection) {
    while (connection.waiting() > 0) {
      const ssize_t size = ::send(connection.socket.native_handle(), connection.queue.data() + connection.sent,
                                  connection.waiting(), MSG_DONTWAIT | MSG_NOSIGNAL);
      if (size < 0) {
        if (errno == EINTR) continue;
        if (errno == EAGAIN || errno == EWOULDBLOCK) break;
        forget_queue(connection);  // the client is gone; reading will say so
        return;
      }
      connection.sent += static_cast<std::size_t>(size);
      queued_ -= static_cast<std::size_t>(size);
    }
    if (connection.waiting() == 0) {
      connection.sent = 0;
      if (connection.queue.capacity() > read_chunk_bytes) {
        std::string().swap(connection.queue);  // a long answer's room is given back
      } else {
        connection.queue.clear();
      }
    }
  }

  void forget_queue(Connection& connection) {
    queued_ -= connection.waiting();
    connection.queue.clear();
    connection.sent = 0;
  }

  /// Sends, and waits for what the connection needs next. The one place that decides this.
  void proceed(const Pointer& connection) {
    if (!connection->socket.is_open()) return;
    send(*connection);
    if (connection->waiting() > 0) {
      await_writable(connection);
    } else if (!connection->is_open && !connection->is_shut) {
      connection->is_shut = true;
      boost::system::error_code ignored;
      connection->socket.shutdown(tcp::socket::shutdown_send, ignored);
    }
    if (connection->is_shut && connection->has_ended) return drop(connection);
    if (!connection->has_ended && connection->waiting() <= pause_reading_bytes) await_readable(connection);
  }

  void await_writable(const Pointer& connection) {
    if (connection->is_writing) return;
    connection->is_writing = true;
    connection->socket.async_wait(tcp::socket::wait_write,
                                  [self = shared_from_this(), connection](const boost::system::error_code& error) {
                                    connection->is_writing = false;
                                    if (!error) self->proceed(connection);
                                  });
  }

  void await_readable(const Pointer& connection) {
    if (connection->is_reading) return;
    connection->is_reading = true;
    connection->socket.async_wait(tcp::socket::wait_read,
                                  [self = shared_from_this(), connection](const boost::system::error_code& error) {
                                    connection->is_reading = false;
                                    if (!error) self->read(connection);
                                  });
  }

  void read(const Pointer& connection) {
    std::array<char, read_chunk_bytes> chunk;
    const ssize_t size = ::recv(connection->socket.native_handle(), chunk.data(), chunk.size(), MSG_DONTWAIT);
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return proceed(connection);
    if (size < 0) forget_queue(*connection);
    if (size <= 0) return end(connection);
    if (connection->is_open) {
      handlers_.bytes(connection->id, {chunk.data(), static_cast<std::size_t>(size)});
    } else {
      connection->lingering += static_cast<std::size_t>(size);
      if (connection->lingering > max_lingering_bytes) return drop(connection);
    }
    proceed(connection);
  }

  /// The client has closed its side: it has withdrawn everything, and gets what was queued for it before.
  void end(const Pointer& connection) {
    connection->has_ended = true;
    if (connection->is_open) {
      connection->is_open = false;
      start_lingering(connection);
      handlers_.closed(connection->id);
    }
    proceed(connection);
  }

  /// The client reads too slowly. It is closed hard, and the participant is told in an event of its own.
  void lose(Pointer connection) {  // by value: the map's own pointer goes
    connection->is_open = false;
    drop(connection);
    net::post(context_, [self = shared_from_this(), id = connection->id] {
      if (!self->is_down_) self->handlers_.closed(id);
    });
  }

  void start_lingering(const Pointer& connection) {
    connection->linger.expires_after(linger_time);
    connection->linger.async_wait([self = shared_from_this(), connection](const boost::system::error_code& error) {
      if (!error) self->drop(connection);
    });
  }

  void drop(Pointer connection) {  // by value, as above
    forget_queue(*connection);
    boost::system::error_code ignored;
    connection->socket.close(ignored);
    connection->linger.cancel();
    connections_.erase(connection->id);
  }

  net::io_context& context_;
  Handlers handlers_;
  std::vector<Door> doors_;
  std::map<StreamId, Pointer> connections_;
  std::vector<Pointer> dirty_;
  std::uint64_t last_id_ = 0;
  std::size_t queued_ = 0;
  bool is_down_ = false;
};

Streams::Streams(net::io_context& context, Handlers handlers)
    : state_(std::make_shared<State>(context, std::move(handlers))) {}
Streams::~Streams() { state_->shut_down(); }
std::expected<void, ListenError> Streams::listen(const Endpoint& endpoint) { return state_->listen(endpoint); }
void Streams::serve() { state_->serve(); }
void Streams::stop_listening() { state_->stop_listening(); }
void Streams::write(StreamId stream, std::string_view bytes) { state_->write(stream, bytes); }
void Streams::close(StreamId stream) { state_->close(stream); }
void Streams::flush() { state_->flush(); }
std::size_t Streams::connection_count() const { return state_->connection_count(); }
bool Streams::is_writing() const { return state_->is_writing(); }

}  // namespace geminga::env
