#include "client/channels/tcp_outlet.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <utility>
#include <vector>

namespace geminga::client {
namespace {

/// The pause of accepting when the process has no descriptor left.
constexpr std::chrono::milliseconds accept_pause{100};

/// The number of octets that the socket took; nothing if it is broken.
std::optional<std::size_t> write_some(const Socket& socket, std::span<iovec> parts) {
  msghdr message{};
  message.msg_iov = parts.data();
  message.msg_iovlen = parts.size();
  while (true) {
    const auto count = ::sendmsg(socket.get(), &message, MSG_NOSIGNAL);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno == EAGAIN) return 0;
    if (errno != EINTR) return std::nullopt;
  }
}

}  // namespace

std::expected<std::unique_ptr<PublisherChannel>, std::string> TcpOutlet::open(ChannelHost& host, ChannelNumber number,
                                                                              Life life,
                                                                              NamedPublication& publication) {
  auto listener = open_listener({publication.address, publication.port});
  if (!listener) return std::unexpected(std::move(listener.error().text));
  std::unique_ptr<TcpOutlet> made(new TcpOutlet(host, number, life, publication.mode));
  made->listener_ = std::move(*listener);
  made->watch_ =
      host.reactor().watch(made->listener_, [publisher = made.get()](Reactor::Ready) { publisher->accept_all(); });
  publication.port = port_of(made->listener_);
  return made;
}

TcpOutlet::TcpOutlet(ChannelHost& host, ChannelNumber number, Life life, ChannelMode mode)
    : PublisherChannel(host, number, life),
      mode_(mode),
      deadline_(host.reactor(),
                [this] {
                  const auto at = now();
                  std::vector<Number> over;
                  for (const auto& [connection_number, connection] : connections_) {
                    if (connection.until <= at) over.push_back(connection_number);
                  }
                  for (const Number one : over) close(one);
                  set_deadline();
                }),
      retry_(host.reactor(), [this] {
        watch_.want(true, false);
        accept_all();
      }) {}

bool TcpOutlet::has_room(std::size_t payload_bytes) const {
  return std::ranges::all_of(connections_, [payload_bytes](const auto& one) {
    return one.second.role != Role::consumer || one.second.queue.has_room(payload_bytes);
  });
}

void TcpOutlet::transmit(const FrameHeader& header, std::span<const std::byte> payload) {
  SendQueue::Shared shared;
  std::vector<Number> broken;
  for (auto& [number, connection] : connections_) {
    if (connection.role != Role::consumer) continue;
    if (!connection.queue.has_room(payload.size())) {
      ++count_.left_out;
      continue;
    }
    std::size_t written = 0;
    if (connection.queue.is_empty()) {
      std::array parts{part(header), part(payload)};
      const auto taken = write_some(connection.socket, parts);
      if (!taken) {
        broken.push_back(number);
        continue;
      }
      written = *taken;
      if (written == header.size() + payload.size()) continue;
    }
    if (!shared) {
      std::vector<std::byte> frame(header.size() + payload.size());
      std::ranges::copy(payload, std::ranges::copy(header, frame.begin()).out);
      shared = std::make_shared<const std::vector<std::byte>>(std::move(frame));
    }
    connection.queue.put(shared, written);
    connection.watch.want(true, true);
  }
  for (const Number number : broken) lose(number);
}

Counterparts::Carrier TcpOutlet::carrier_of(Counterparts::Number consumer) const {
  return is_reached(consumer) ? Counterparts::Carrier::connection : Counterparts::Carrier::no_connection;
}

bool TcpOutlet::is_reached(Counterparts::Number consumer) const {
  return consumer_of(counterparts_.at(consumer).life).has_value();
}

std::optional<TcpOutlet::Number> TcpOutlet::consumer_of(Life life) const {
  if (life == no_life) return std::nullopt;
  const auto found = std::ranges::find_if(
      connections_, [life](const auto& one) { return one.second.role == Role::consumer && one.second.life == life; });
  return found == connections_.end() ? std::nullopt : std::optional(found->first);
}

void TcpOutlet::on_consumer(Counterparts::Number consumer) {
  const Life life = counterparts_.at(consumer).life;
  if (life == no_life) return;
  // Its connections may have come before the event; the last one counts.
  std::vector<Number> waiting;
  for (const auto& [number, connection] : connections_) {
    if (connection.role == Role::stranger && connection.life == life) waiting.push_back(number);
  }
  for (const Number number : waiting) become_consumer(number);
}

void TcpOutlet::on_consumer_gone(Counterparts::Number consumer, bool is_final) {
  if (mode_ == ChannelMode::one_to_many_stream) return;
  const auto connection = consumer_of(counterparts_.at(consumer).life);
  if (!connection) return;
  if (is_final) {
    leave(*connection);
  } else {
    close(*connection);
  }
}

void TcpOutlet::accept_all() {
  while (auto socket = accept(listener_)) {
    const auto is_stranger = [](const auto& one) { return one.second.role == Role::stranger; };
    if (static_cast<std::size_t>(std::ranges::count_if(connections_, is_stranger)) == max_strangers) {
      ++count_.dropped;
      close(std::ranges::find_if(connections_, is_stranger)->first);
    }
    const Number number = ++last_;
    Connection& connection = connections_[number];
    connection.socket = std::move(*socket);
    connection.until = now() + stranger_patience;
    connection.watch =
        host_.reactor().watch(connection.socket, [this, number](Reactor::Ready ready) { on_ready(number, ready); });
  }
  if (errno == EMFILE || errno == ENFILE) {
    // To try again at once would only spin.
    watch_.want(false, false);
    retry_.set(now() + accept_pause);
  }
  set_deadline();
}

void TcpOutlet::on_ready(Number connection, Reactor::Ready ready) {
  if (ready.can_read && !read(connection)) return;
  if (ready.can_write) write(connection);
}

bool TcpOutlet::read(Number number) {
  Connection& connection = connections_.at(number);
  const auto room = connection.reader.room();
  const auto count = ::recv(connection.socket.get(), room.data(), room.size(), 0);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return true;
  if (count <= 0) {
    lose(number);
    return false;
  }
  connection.reader.fed(static_cast<std::size_t>(count));
  while (const auto frame = connection.reader.next()) {
    if (!take(number, *frame)) return false;
  }
  if (!connection.reader.is_broken()) return true;
  ++count_.dropped;
  lose(number);
  return false;
}

bool TcpOutlet::take(Number number, const Frame& frame) {
  Connection& connection = connections_.at(number);
  if (connection.role != Role::stranger) return true;  // a consumer has nothing more to say
  if (frame.kind != FrameKind::hello || frame.life == no_life || connection.life != no_life) {
    ++count_.dropped;
    close(number);
    return false;
  }
  connection.life = frame.life;
  if (mode_ == ChannelMode::one_to_many_stream || counterparts_.find(frame.life)) return become_consumer(number);
  return true;
}

bool TcpOutlet::become_consumer(Number number) {
  Connection& connection = connections_.at(number);
  if (const auto other = consumer_of(connection.life)) close(*other);
  if (consumer_connections_ == max_tcp_consumers) {
    ++count_.dropped;
    close(number);
    return false;
  }
  connection.role = Role::consumer;
  connection.until = base::never;
  ++consumer_connections_;
  set_deadline();
  if (const auto counterpart = counterparts_.find(connection.life)) appear(*counterpart);
  return true;
}

bool TcpOutlet::write(Number number) {
  Connection& connection = connections_.at(number);
  while (!connection.queue.is_empty()) {
    std::array parts{part(connection.queue.front())};
    const auto written = write_some(connection.socket, parts);
    if (!written) {
      lose(number);
      return false;
    }
    if (*written == 0) break;
    connection.queue.wrote(*written);
    if (connection.role == Role::leaving) connection.until = now() + leaving_patience;
  }
  connection.watch.want(true, !connection.queue.is_empty());
  if (connection.role != Role::leaving) return true;
  if (connection.queue.is_empty() && !std::exchange(connection.has_ended, true)) {
    ::shutdown(connection.socket.get(), SHUT_WR);
  }
  set_deadline();
  return true;
}

void TcpOutlet::lose(Number number) {
  const Life life = connections_.at(number).life;
  const bool was_consumer = connections_.at(number).role == Role::consumer;
  close(number);
  if (!was_consumer) return;
  if (const auto counterpart = counterparts_.find(life)) vanish(*counterpart);
}

void TcpOutlet::leave(Number number) {
  Connection& connection = connections_.at(number);
  if (connection.role == Role::consumer) --consumer_connections_;
  connection.role = Role::leaving;
  connection.until = now() + leaving_patience;
  write(number);
}

void TcpOutlet::close(Number number) {
  const auto found = connections_.find(number);
  if (found == connections_.end()) return;
  if (found->second.role == Role::consumer) --consumer_connections_;
  found->second.watch.stop();
  connections_.erase(found);
}

void TcpOutlet::set_deadline() {
  base::Instant next = base::never;
  for (const auto& [number, connection] : connections_) next = std::min(next, connection.until);
  deadline_.set(next);
}

void TcpOutlet::finish() {
  if (is_closed_) return;
  is_closed_ = true;
  watch_.stop();
  retry_.set(base::never);
  listener_.close();
  const auto end = std::make_shared<const std::vector<std::byte>>(frame_bytes({FrameKind::end, life_, sequence_, {}}));
  std::vector<Number> all;
  for (const auto& [number, connection] : connections_) all.push_back(number);
  for (const Number number : all) {
    Connection& connection = connections_.at(number);
    if (connection.role == Role::stranger) {
      close(number);
    } else if (connection.role == Role::consumer) {
      connection.queue.put(end);
      leave(number);
    }
  }
  set_deadline();
}

}  // namespace geminga::client
