#include "env/asio/streams.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <map>
#include <utility>

#include "env/asio/send_queue.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;

struct Connection {
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
  bool is_behind = false;     // the participant knows that something waits, and waits for it to have gone
  bool is_shut = false;       // our side has said all
  bool has_ended = false;     // its side has said all

  [[nodiscard]] std::size_t waiting() const { return queue.waiting().size(); }
};

}  // namespace

class Streams::State : public std::enable_shared_from_this<Streams::State> {
 public:
  State(net::io_context& context, Handlers handlers) : context_(context), handlers_(std::move(handlers)) {}

  Doors& doors() { return *doors_; }

  void serve() {
    doors_->serve([weak = weak_from_this()](Doors::Socket socket) {
      if (const auto self = weak.lock()) self->take(std::move(socket));
    });
  }

  void shut_down() {
    is_down_ = true;
    doors_->close();
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
    append(connection, bytes);
    mark(found->second);
    if (connection.queue.held() > max_queued_bytes) {
      send(connection);  // the kernel may have room for what this event has written
      if (connection.queue.held() > max_queued_bytes) return lose(found->second);
    }
    if (held_ > max_queued_bytes_in_all) lose_greediest();
  }

  [[nodiscard]] std::size_t unsent(StreamId stream) const {
    const auto found = connections_.find(stream);
    if (found == connections_.end() || !found->second->is_open) return 0;
    // Who learns now that something waits may wait for on_stream_drained(), even if the end of this event sends all of
    // it.
    if (found->second->waiting() > 0) found->second->is_behind = true;
    return found->second->waiting();
  }

  void want(StreamId stream, bool is_wanted) {
    const auto found = connections_.find(stream);
    if (found == connections_.end() || found->second->is_wanted == is_wanted) return;
    found->second->is_wanted = is_wanted;
    if (is_wanted) mark(found->second);
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

  [[nodiscard]] bool is_writing() const {
    return std::ranges::any_of(connections_, [](const auto& entry) { return entry.second->waiting() > 0; });
  }

 private:
  using Pointer = std::shared_ptr<Connection>;

  void take(Doors::Socket socket) {
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

  /// A connection that is closed already and only takes its last lines gives way to a new one.
  bool drop_oldest_closed() {
    const auto found = std::ranges::find_if(connections_, [](const auto& entry) { return !entry.second->is_open; });
    if (found == connections_.end()) return false;
    drop(found->second);
    return true;
  }

  void mark(const Pointer& connection) {
    if (connection->is_dirty) return;
    connection->is_dirty = true;
    dirty_.push_back(connection);
  }

  /// Hands what is queued to the kernel, as far as it takes it.
  void send(Connection& connection) {
    while (connection.waiting() > 0) {
      const std::string_view bytes = connection.queue.waiting();
      const ssize_t size =
          ::send(connection.socket.native_handle(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
      if (size < 0) {
        if (errno == EINTR) continue;
        if (errno == EAGAIN || errno == EWOULDBLOCK) break;
        forget_queue(connection);  // the client is gone; reading will say so
        return;
      }
      change_queue(connection, [&] { connection.queue.drop(static_cast<std::size_t>(size)); });
    }
  }

  /// Every change of a queue, so that what all of them hold is known.
  template <typename Action>
  void change_queue(Connection& connection, Action&& action) {
    held_ -= connection.queue.held();
    action();
    held_ += connection.queue.held();
  }

  void append(Connection& connection, std::string_view bytes) {
    change_queue(connection, [&] { connection.queue.append(bytes); });
  }

  void forget_queue(Connection& connection) {
    change_queue(connection, [&] { connection.queue.clear(); });
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
      connection->socket.shutdown(net::socket_base::shutdown_send, ignored);
    }
    if (connection->is_shut && connection->has_ended) return drop(connection);
    if (!connection->has_ended && (connection->is_wanted || !connection->is_open)) await_readable(connection);
    if (connection->waiting() > 0) return;
    if (std::exchange(connection->is_behind, false) && connection->is_open) tell_drained(connection->id);
  }

  /// In an event of its own: this one may be the end of another.
  void tell_drained(StreamId id) {
    net::post(context_, [self = shared_from_this(), id] {
      const auto found = self->connections_.find(id);
      if (found != self->connections_.end() && found->second->is_open) self->handlers_.drained(id);
    });
  }

  void await_writable(const Pointer& connection) {
    if (connection->is_writing) return;
    connection->is_writing = true;
    connection->socket.async_wait(net::socket_base::wait_write,
                                  [self = shared_from_this(), connection](const boost::system::error_code& error) {
                                    connection->is_writing = false;
                                    if (!error) self->proceed(connection);
                                  });
  }

  void await_readable(const Pointer& connection) {
    if (connection->is_reading) return;
    connection->is_reading = true;
    connection->socket.async_wait(net::socket_base::wait_read,
                                  [self = shared_from_this(), connection](const boost::system::error_code& error) {
                                    connection->is_reading = false;
                                    if (!error) self->read(connection);
                                  });
  }

  void read(const Pointer& connection) {
    if (connection->is_open && !connection->is_wanted) return;  // it was, when the wait began
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
  void lose(Pointer connection) {  // NOLINT(performance-unnecessary-value-param): the map's own pointer goes
    connection->is_open = false;
    drop(connection);
    net::post(context_, [self = shared_from_this(), id = connection->id] {
      if (!self->is_down_) self->handlers_.closed(id);
    });
  }

  /// The one that holds the most pays for all, not the one that comes next.
  void lose_greediest() {
    const auto greediest =
        std::ranges::max_element(connections_, {}, [](const auto& entry) { return entry.second->queue.held(); });
    if (greediest->second->is_open) return lose(greediest->second);
    drop(greediest->second);
  }

  void start_lingering(const Pointer& connection) {
    connection->linger.expires_after(linger_time);
    connection->linger.async_wait([self = shared_from_this(), connection](const boost::system::error_code& error) {
      if (!error) self->drop(connection);
    });
  }

  void drop(Pointer connection) {  // NOLINT(performance-unnecessary-value-param): as above
    forget_queue(*connection);
    boost::system::error_code ignored;
    connection->socket.close(ignored);
    connection->linger.cancel();
    connections_.erase(connection->id);
  }

  net::io_context& context_;
  Handlers handlers_;
  std::shared_ptr<Doors> doors_ = std::make_shared<Doors>(context_);
  std::map<StreamId, Pointer> connections_;
  std::vector<Pointer> dirty_;
  std::uint64_t last_id_ = 0;
  std::size_t held_ = 0;  // by all queues
  bool is_down_ = false;
};

Streams::Streams(net::io_context& context, Handlers handlers)
    : state_(std::make_shared<State>(context, std::move(handlers))) {}
Streams::~Streams() { state_->shut_down(); }
std::expected<void, ListenError> Streams::listen(const Endpoint& endpoint) { return state_->doors().listen(endpoint); }
std::expected<void, std::string> Streams::listen(const std::string& path) { return state_->doors().listen(path); }
void Streams::serve() { state_->serve(); }
void Streams::stop_listening() { state_->doors().close(); }
void Streams::write(StreamId stream, std::string_view bytes) { state_->write(stream, bytes); }
std::size_t Streams::unsent(StreamId stream) const { return state_->unsent(stream); }
void Streams::want(StreamId stream, bool is_wanted) { state_->want(stream, is_wanted); }
void Streams::close(StreamId stream) { state_->close(stream); }
void Streams::flush() { state_->flush(); }
bool Streams::is_writing() const { return state_->is_writing(); }

}  // namespace geminga::env
