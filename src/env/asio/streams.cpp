#include "env/asio/streams.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <utility>

#include "env/asio/send_queue.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;

}  // namespace

struct Streams::Connection {
  Connection(StreamId number, Doors::Socket accepted)
      : id(number), socket(std::move(accepted)), linger(socket.get_executor()) {}

  StreamId id;
  Doors::Socket socket;
  net::steady_timer linger;
  SendQueue queue;
  std::size_t lingering = 0;  // octets thrown away since it was closed
  bool is_open = true;        // the participant knows it
  bool is_wanted = true;      // the participant wants to hear more of it
  bool is_dirty = false;      // waits for flush()
  bool is_reading = false;    // a wait for readability is under way
  bool is_writing = false;    // a wait for writability is under way
  bool is_behind = false;     // the participant knows that something waits, and waits for on_stream_drained()
  bool is_shut = false;       // our side has said all
  bool has_ended = false;     // its side has said all

  [[nodiscard]] std::size_t waiting() const { return queue.waiting().size(); }
};

Streams::Streams(net::io_context& context, Handlers handlers)
    : context_(context), handlers_(std::move(handlers)), doors_(std::make_shared<Doors>(context)) {}

Streams::~Streams() = default;

void Streams::serve() {
  doors_->serve([weak = weak_from_this()](Doors::Socket socket) {
    if (const auto self = weak.lock()) self->take(std::move(socket));
  });
}

void Streams::shut_down() {
  is_down_ = true;
  doors_->close();
  boost::system::error_code ignored;
  for (auto& [id, connection] : connections_) {
    connection->socket.close(ignored);
    connection->linger.cancel();
  }
  connections_.clear();
}

void Streams::write(StreamId stream, std::string_view bytes) {
  const auto found = connections_.find(stream);
  if (found == connections_.end() || !found->second->is_open) return;
  Connection& connection = *found->second;
  append(connection, bytes);
  mark(found->second);
  if (connection.queue.held() > max_queued_bytes) {
    send(connection);  // the kernel may have room for what this event has written
    if (connection.queue.held() > max_queued_bytes) return lose(found->second);
  }
  if (held_ > max_queued_bytes_in_all) lose_greediest();
}

std::size_t Streams::unsent(StreamId stream) const {
  const auto found = connections_.find(stream);
  if (found == connections_.end() || !found->second->is_open) return 0;
  // The caller may wait for on_stream_drained() from now on, even if the end of this event sends all of it.
  if (found->second->waiting() > 0) found->second->is_behind = true;
  return found->second->waiting();
}

void Streams::want(StreamId stream, bool is_wanted) {
  const auto found = connections_.find(stream);
  if (found == connections_.end() || found->second->is_wanted == is_wanted) return;
  found->second->is_wanted = is_wanted;
  if (is_wanted) mark(found->second);
}

void Streams::close(StreamId stream) {
  const auto found = connections_.find(stream);
  if (found == connections_.end() || !found->second->is_open) return;
  found->second->is_open = false;
  start_lingering(found->second);
  mark(found->second);
}

void Streams::flush() {
  std::vector<std::shared_ptr<Connection>> dirty;
  dirty.swap(dirty_);
  for (const auto& connection : dirty) {
    connection->is_dirty = false;
    proceed(connection);
  }
}

bool Streams::is_writing() const {
  return std::ranges::any_of(connections_, [](const auto& entry) { return entry.second->waiting() > 0; });
}

void Streams::take(Doors::Socket socket) {
  boost::system::error_code error;
  if (connections_.size() >= max_connections && !drop_oldest_closed()) {
    socket.close(error);
    return;
  }
  socket.set_option(net::ip::tcp::no_delay(true), error);  // a Unix socket has no such option and needs none
  const StreamId id{++last_id_};
  const auto connection = std::make_shared<Connection>(id, std::move(socket));
  connections_.emplace(id, connection);
  handlers_.opened(id, user_of(connection->socket.native_handle()));
  proceed(connection);
}

bool Streams::drop_oldest_closed() {
  const auto found = std::ranges::find_if(connections_, [](const auto& entry) { return !entry.second->is_open; });
  if (found == connections_.end()) return false;
  drop(found->second);
  return true;
}

void Streams::mark(const Pointer& connection) {
  if (connection->is_dirty) return;
  connection->is_dirty = true;
  dirty_.push_back(connection);
}

void Streams::send(Connection& connection) {
  while (connection.waiting() > 0) {
    const std::string_view bytes = connection.queue.waiting();
    const ssize_t size =
        ::send(connection.socket.native_handle(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (size < 0) {
      if (errno == EINTR) continue;
      if (errno == EAGAIN || errno == EWOULDBLOCK) break;
      forget_queue(connection);  // the client is gone; reading will tell
      return;
    }
    change_queue(connection, [&] { connection.queue.drop(static_cast<std::size_t>(size)); });
  }
}

template <typename Action>
void Streams::change_queue(Connection& connection, Action&& action) {
  held_ -= connection.queue.held();
  action();
  held_ += connection.queue.held();
}

void Streams::append(Connection& connection, std::string_view bytes) {
  change_queue(connection, [&] { connection.queue.append(bytes); });
}

void Streams::forget_queue(Connection& connection) {
  change_queue(connection, [&] { connection.queue.clear(); });
}

void Streams::proceed(const Pointer& connection) {
  if (!connection->socket.is_open()) return;
  send(*connection);
  if (connection->waiting() > 0) {
    await_writable(connection);
  } else if (!connection->is_open && !connection->is_shut) {
    connection->is_shut = true;
    boost::system::error_code ignored;
    connection->socket.shutdown(net::socket_base::shutdown_send, ignored);
  }
  if (connection->is_shut && connection->has_ended) return drop(connection);
  if (!connection->has_ended && (connection->is_wanted || !connection->is_open)) await_readable(connection);
  if (connection->waiting() > 0) return;
  if (std::exchange(connection->is_behind, false) && connection->is_open) tell_drained(connection->id);
}

void Streams::tell_drained(StreamId id) {
  net::post(context_, [self = shared_from_this(), id] {
    const auto found = self->connections_.find(id);
    if (found != self->connections_.end() && found->second->is_open) self->handlers_.drained(id);
  });
}

void Streams::await_writable(const Pointer& connection) {
  if (connection->is_writing) return;
  connection->is_writing = true;
  connection->socket.async_wait(net::socket_base::wait_write,
                                [self = shared_from_this(), connection](const boost::system::error_code& error) {
                                  connection->is_writing = false;
                                  if (!error) self->proceed(connection);
                                });
}

void Streams::await_readable(const Pointer& connection) {
  if (connection->is_reading) return;
  connection->is_reading = true;
  connection->socket.async_wait(net::socket_base::wait_read,
                                [self = shared_from_this(), connection](const boost::system::error_code& error) {
                                  connection->is_reading = false;
                                  if (!error) self->read(connection);
                                });
}

void Streams::read(const Pointer& connection) {
  if (connection->is_open && !connection->is_wanted) return;  // it was wanted when the wait began
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

void Streams::end(const Pointer& connection) {
  connection->has_ended = true;
  if (connection->is_open) {
    connection->is_open = false;
    start_lingering(connection);
    handlers_.closed(connection->id);
  }
  proceed(connection);
}

void Streams::lose(Pointer connection) {  // NOLINT(performance-unnecessary-value-param): the map's own pointer goes
  connection->is_open = false;
  drop(connection);
  net::post(context_, [self = shared_from_this(), id = connection->id] {
    if (!self->is_down_) self->handlers_.closed(id);
  });
}

void Streams::lose_greediest() {
  const auto greediest =
      std::ranges::max_element(connections_, {}, [](const auto& entry) { return entry.second->queue.held(); });
  if (greediest->second->is_open) return lose(greediest->second);
  drop(greediest->second);
}

void Streams::start_lingering(const Pointer& connection) {
  connection->linger.expires_after(linger_time);
  connection->linger.async_wait([self = shared_from_this(), connection](const boost::system::error_code& error) {
    if (!error) self->drop(connection);
  });
}

void Streams::drop(Pointer connection) {  // NOLINT(performance-unnecessary-value-param): as above
  forget_queue(*connection);
  boost::system::error_code ignored;
  connection->socket.close(ignored);
  connection->linger.cancel();
  connections_.erase(connection->id);
}

}  // namespace geminga::env
