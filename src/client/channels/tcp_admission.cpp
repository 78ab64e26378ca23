// The handshake by which a connection becomes a consumer of a publisher over TCP.
#include <algorithm>
#include <vector>

#include "client/channels/tcp_outlet.hpp"

namespace geminga::client {

void TcpOutlet::on_keys(bool seals_newly) {
  if (!is_closed_ && retry_.at() == base::never) watch_.want(true, false);
  if (!seals_newly && takes_plain()) return;
  std::vector<Number> consumers;
  for (auto& [number, connection] : connections_) {
    if (connection.role == Role::consumer) consumers.push_back(number);
  }
  for (const Number number : consumers) {
    Connection& connection = connections_.at(number);
    // Consumers that were accepted without a floor can believe what follows this one.
    std::uint64_t cookie = 0;
    if (!takes_plain() && !connection.is_proved) {
      // They have to say a sealed hello in time.
      cookie = connection.cookie = random_number();
      connection.until = now() + stranger_patience;
    } else if (!seals_newly) {
      continue;
    }
    put_greeting(number, FrameKind::floor, cookie);
  }
  set_deadline();
}

void TcpOutlet::prove(Connection& connection, const ReadFrame& read) {
  if (connection.is_proved || read.form == FrameForm::plain || read.life != connection.life) return;
  const auto opened = open_frame(read, *keys_, Direction::back, opened_);
  const auto greeting = opened ? read_greeting(opened->payload) : std::nullopt;
  const Greeting wanted{life_, connection.challenge, connection.cookie};
  if (!greeting || opened->kind != FrameKind::hello || greeting != wanted || wanted.cookie == 0) return;
  connection.is_proved = true;
  connection.counter = seal_fields(read).counter;
  connection.until = base::never;
}

bool TcpOutlet::take(Number number, const ReadFrame& read) {
  Connection& connection = connections_.at(number);
  if (connection.role == Role::consumer) prove(connection, read);
  if (connection.role != Role::stranger) return true;  // it has nothing more to say
  bool is_believed = false;
  if (read.form == FrameForm::plain) {
    is_believed = takes_plain() && greet(number, read, std::nullopt);
  } else if (const auto opened = open_frame(read, *keys_, Direction::back, opened_)) {
    is_believed = greet(number, *opened, seal_fields(read).counter);
  }
  if (!is_believed) {
    ++count_.dropped;
    close(number);
    return false;
  }
  if (!connections_.contains(number)) return false;  // it could not be answered
  if (!connection.has_greeted) return true;
  if (mode_ == ChannelMode::one_to_many_stream || counterparts_.find(read.life)) return become_consumer(number);
  return true;
}

bool TcpOutlet::greet(Number number, const Frame& hello, std::optional<std::uint64_t> counter) {
  Connection& connection = connections_.at(number);
  const auto greeting = read_greeting(hello.payload);
  if (hello.kind != FrameKind::hello || !greeting || greeting->life != life_ || greeting->challenge == 0) return false;
  if (connection.has_greeted) return false;
  if (connection.life == no_life) {
    connection.life = hello.life;
    connection.challenge = greeting->challenge;
    connection.counter = counter.value_or(0);
    connection.is_proved = counter.has_value();
    connection.has_greeted = !counter && !seals();
    if (connection.has_greeted) return true;
    // Its next hello shows by this cookie that it is no recording.
    connection.cookie = random_number();
    put_greeting(number, FrameKind::floor, connection.cookie);
    return true;
  }
  const bool is_same = connection.life == hello.life && connection.challenge == greeting->challenge &&
                       connection.cookie == greeting->cookie && connection.is_proved == counter.has_value();
  if (!is_same || (counter && *counter <= connection.counter)) return false;
  connection.counter = counter.value_or(0);
  connection.has_greeted = true;
  return true;
}

bool TcpOutlet::become_consumer(Number number) {
  if (const auto other = consumer_of(connections_.at(number).life)) close(*other);
  Connection& connection = connections_.at(number);
  const auto given = consumer_places_.take(++last_place_, connection.from);
  if (!given.is_taken || given.loser) tell_crowding(crowding_.on_full(), consumer_places_, "consumers");
  if (given.loser) {
    const auto loser = std::ranges::find(connections_, *given.loser, [](const auto& one) { return one.second.place; });
    const Life life = loser->second.life;
    put_greeting(loser->first, FrameKind::full, 0);
    if (connections_.contains(loser->first)) leave(loser->first);
    if (const auto counterpart = counterparts_.find(life)) vanish(*counterpart);
  }
  strangers_.leave(number);
  if (!given.is_taken) {
    ++count_.dropped;
    put_greeting(number, FrameKind::full, 0);
    if (connections_.contains(number)) leave(number);
    return false;
  }
  connection.place = last_place_;
  connection.role = Role::consumer;
  connection.until = base::never;
  ++consumer_connections_;
  set_deadline();
  if (connection.cookie != 0) put_greeting(number, FrameKind::floor, 0);
  if (!connections_.contains(number)) return false;
  if (const auto counterpart = counterparts_.find(connection.life)) appear(*counterpart);
  return true;
}

void TcpOutlet::put(Number number, FrameKind kind, std::span<const std::byte> payload) {
  Connection& connection = connections_.at(number);
  auto frame = sealer_.frame(*keys_, kind, sequence_, payload);
  if (!frame) return;
  if (connection.queue.is_empty()) connection.took = now();
  connection.queue.put(waiting_.share(std::move(*frame)));
}

void TcpOutlet::put_greeting(Number number, FrameKind kind, std::uint64_t cookie) {
  const Connection& connection = connections_.at(number);
  put(number, kind, greeting_payload({connection.life, connection.challenge, cookie}));
  write(number);
}

}  // namespace geminga::client
