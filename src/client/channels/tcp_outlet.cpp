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
/// The reason for the end of a consumer that takes nothing while too much waits.
constexpr std::string_view slow_reason = "slow";

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
  // Nobody is accepted before the keys are known: connections wait in the system until then.
  made->watch_.want(false, false);
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
                  for (const Number one : over) lose(one);
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

void TcpOutlet::transmit(std::span<const std::byte> payload) {
  SendQueue::Shared shared;
  FrameHeader header{};
  if (seals()) {
    std::vector<std::byte> frame(sealed_size(payload.size()));
    if (!sealer_.seal(*keys_, FrameKind::message, sequence_, payload, 0, frame.data())) return finish();
    shared = waiting_.share(std::move(frame));
  } else {
    header = frame_header(FrameKind::message, life_, sequence_, payload.size());
  }
  std::vector<Number> broken;
  for (auto& [number, connection] : connections_) {
    if (connection.role != Role::consumer) continue;
    if (!connection.queue.has_room(payload.size())) {
      ++count_.left_out;
      if (!std::exchange(connection.was_told_slow, true)) {
        problem("the consumer " + to_string(connection.life) +
                " is slow: messages to it are left out until it has taken some");
      }
      continue;
    }
    std::size_t written = 0;
    if (connection.queue.is_empty()) {
      std::array parts{shared ? part(*shared) : part(header), shared ? iovec{} : part(payload)};
      const auto taken = write_some(connection.socket, parts);
      if (!taken) {
        broken.push_back(number);
        continue;
      }
      written = *taken;
      if (written == (shared ? shared->size() : header.size() + payload.size())) continue;
      connection.took = now();
    }
    if (!shared) {
      std::vector<std::byte> frame(header.size() + payload.size());
      std::ranges::copy(payload, std::ranges::copy(header, frame.begin()).out);
      shared = waiting_.share(std::move(frame));
    }
    connection.queue.put(shared, written);
    connection.watch.want(true, true);
  }
  for (const Number number : broken) lose(number);
  shared.reset();
  relieve();
}

void TcpOutlet::relieve() {
  while (waiting_.octets() > max_waiting_for_consumers) {
    auto slowest = connections_.end();
    for (auto one = connections_.begin(); one != connections_.end(); ++one) {
      if (one->second.queue.is_empty()) continue;
      if (slowest == connections_.end() || one->second.took < slowest->second.took) slowest = one;
    }
    if (slowest == connections_.end()) return;
    lose(slowest->first, slow_reason);
  }
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
    if (connection.role == Role::stranger && connection.has_greeted && connection.life == life) {
      waiting.push_back(number);
    }
  }
  for (const Number number : waiting) {
    if (connections_.contains(number)) become_consumer(number);
  }
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
  while (auto socket = accept(listener_)) add(std::move(*socket));
  if (errno == EMFILE || errno == ENFILE) {
    // To try again at once would only spin.
    watch_.want(false, false);
    retry_.set(now() + accept_pause);
  }
  set_deadline();
}

void TcpOutlet::add(Socket socket) {
  const Number number = ++last_;
  const PeerAddress from = peer_of(socket);
  const auto given = strangers_.take(number, from);
  if (given.loser) close(*given.loser);
  if (given.loser || !given.is_taken) ++count_.dropped;
  if (!given.is_taken) return;
  Connection& connection = connections_[number];
  connection.socket = std::move(socket);
  connection.from = from;
  connection.until = now() + stranger_patience;
  connection.watch =
      host_.reactor().watch(connection.socket, [this, number](Reactor::Ready ready) { on_ready(number, ready); });
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
    connection.took = now();
    if (connection.role == Role::leaving) connection.until = now() + leaving_patience;
  }
  connection.watch.want(true, !connection.queue.is_empty());
  if (connection.queue.is_empty()) connection.was_told_slow = false;
  if (connection.role != Role::leaving) return true;
  if (connection.queue.is_empty() && !std::exchange(connection.has_ended, true)) {
    ::shutdown(connection.socket.get(), SHUT_WR);
  }
  set_deadline();
  return true;
}

void TcpOutlet::lose(Number number, std::string_view reason) {
  const Life life = connections_.at(number).life;
  const bool was_consumer = connections_.at(number).role == Role::consumer;
  close(number);
  if (!was_consumer) return;
  if (const auto counterpart = counterparts_.find(life)) vanish(*counterpart, reason);
}

void TcpOutlet::leave_place(Number number) {
  Connection& connection = connections_.at(number);
  if (connection.role == Role::consumer) --consumer_connections_;
  strangers_.leave(number);
  consumer_places_.leave(std::exchange(connection.place, 0));
  tell_crowding(crowding_.on_left(consumer_places_), consumer_places_, "consumers");
}

void TcpOutlet::leave(Number number) {
  leave_place(number);
  Connection& connection = connections_.at(number);
  connection.role = Role::leaving;
  connection.until = now() + leaving_patience;
  write(number);
}

void TcpOutlet::close(Number number) {
  const auto found = connections_.find(number);
  if (found == connections_.end()) return;
  leave_place(number);
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
  std::vector<Number> all;
  for (const auto& [number, connection] : connections_) all.push_back(number);
  for (const Number number : all) {
    Connection& connection = connections_.at(number);
    if (connection.role == Role::stranger) {
      close(number);
    } else if (connection.role == Role::consumer) {
      put(number, FrameKind::end, {});
      leave(number);
    }
  }
  set_deadline();
}

}  // namespace geminga::client
