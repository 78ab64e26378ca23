// How a subscriber's sockets follow the events of its providers, and what it reads from them.
#include <array>
#include <utility>

#include "client/channels/converter.hpp"
#include "client/channels/life.hpp"
#include "client/channels/subscriber_channel.hpp"

namespace geminga::client {
namespace {

/// Datagrams that are read before others have their turn.
constexpr int datagrams_a_turn = 256;

}  // namespace

void SubscriberChannel::wire(Parties::Number number, const ServiceEvent& event) {
  Provider& provider = providers_.at(number);
  const NamedPublication& offer = event.publication;
  const Life life = parties_.at(number).life;
  const auto address = peer_address(offer.address, offer.port);
  Way way = Way::none;
  if (!address) {
    problem("the provider " + to_string(event.service) + " has no address that can be reached");
  } else if (offer.protocol == "udp") {
    const bool is_stream = offer.mode == ChannelMode::one_to_many_stream;
    way = is_stream && address->is_multicast() ? Way::group
          : is_stream && life != no_life       ? Way::hello
                                               : Way::datagrams;
  } else if (offer.protocol == "tcp" && life != no_life) {
    way = Way::connection;
  } else {
    problem("no channel to the provider " + to_string(event.service) +
            (offer.protocol == "tcp" ? ": it states no life" : ": it speaks " + offer.protocol));
  }
  if (way == provider.way && (way == Way::none || *address == provider.address)) return;

  if (provider.way == Way::hello) say(provider, FrameKind::end);
  const auto old = by_address_.find(provider.address);
  if (old != by_address_.end() && old->second == number) by_address_.erase(old);
  provider.connection.reset();
  provider.group_watch.stop();
  provider.group.close();
  provider.way = way;
  provider.address = address.value_or(PeerAddress{});
  if (way == Way::datagrams || way == Way::hello) by_address_[provider.address] = number;
  if (way == Way::hello) say_hello();
  if (way == Way::group) join(number);
  if (way == Way::connection) connect(number);
  if (way == Way::datagrams || way == Way::hello) deliver_early(number);
}

void SubscriberChannel::deliver_early(Parties::Number number) {
  for (const auto& kept : early_.take(providers_.at(number).address, parties_.at(number).life, now())) {
    --count_.dropped;
    take_frame(number, kept.frame());
    if (!providers_.contains(number)) return;  // it has ended already
  }
}

void SubscriberChannel::connect(Parties::Number number) {
  Provider& provider = providers_.at(number);
  ProviderConnection::Told told;
  told.frame = [this, number](const Frame& frame) { return take_frame(number, frame); };
  told.lost = [this, number] { return on_lost(number); };
  told.broken = [this] { ++count_.dropped; };
  provider.connection = std::make_unique<ProviderConnection>(host_.reactor(), provider.address, life_, std::move(told));
  if (is_paused_) provider.connection->pause(true);
  provider.connection->start();
}

void SubscriberChannel::join(Parties::Number number) {
  Provider& provider = providers_.at(number);
  auto group = open_group(provider.address);
  if (!group) return problem("the group " + to_string(provider.address) + " cannot be joined: " + group.error().text);
  provider.group = std::move(*group);
  provider.group_watch = host_.reactor().watch(provider.group, [this, number](Reactor::Ready) {
    if (const auto found = providers_.find(number); found != providers_.end()) read(found->second.group, number);
  });
  provider.group_watch.want(!is_paused_, false);
  interfaces_.set(now() + interfaces_interval);
}

void SubscriberChannel::join_all() {
  bool has_group = false;
  for (const auto& [number, provider] : providers_) {
    if (provider.way != Way::group) continue;
    has_group = true;
    join_group(provider.group, provider.address);
  }
  interfaces_.set(has_group ? now() + interfaces_interval : base::never);
}

bool SubscriberChannel::on_lost(Parties::Number number) {
  const Parties::Party& party = parties_.at(number);
  if (party.state == Parties::State::matched) return true;
  if (party.state == Parties::State::doubted) {
    remove(number, Parties::disconnected_reason);
    return false;
  }
  remove(number, party.reason);
  set_timer();
  return false;
}

void SubscriberChannel::read(const Socket& socket, std::optional<Parties::Number> group) {
  const auto room = host_.datagram_room();
  for (int i = 0; i < datagrams_a_turn && !is_paused_ && socket.is_open(); ++i) {
    sockaddr_storage from{};
    socklen_t size = sizeof from;
    const auto count = ::recvfrom(socket.get(), room.data(), room.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (count < 0) return;
    take_datagram(room.first(static_cast<std::size_t>(count)), peer_address(from), group);
    if (group && !providers_.contains(*group)) return;  // and the socket with it
  }
}

void SubscriberChannel::take_datagram(std::span<const std::byte> bytes, const PeerAddress& from,
                                      std::optional<Parties::Number> group) {
  std::optional<Parties::Number> number;
  if (group) {
    if (from.port == providers_.at(*group).address.port) number = group;
  } else if (const auto found = by_address_.find(from); found != by_address_.end()) {
    number = found->second;
  }
  if (number && parties_.at(*number).life == no_life) {
    deliver(*number, 0, bytes);
    return;
  }
  const auto frame = read_frame(bytes);
  if (!frame) {
    ++count_.dropped;
  } else if (number && (group || frame->life == parties_.at(*number).life)) {
    take_frame(*number, *frame);
  } else {
    take_early(*frame, from);
  }
}

void SubscriberChannel::take_early(const Frame& frame, const PeerAddress& from) {
  ++count_.dropped;
  if (frame.kind != FrameKind::hello && frame.life != no_life) early_.put(from, frame, now());
}

bool SubscriberChannel::take_frame(Parties::Number number, const Frame& frame) {
  if (frame.life != parties_.at(number).life || frame.kind == FrameKind::hello) {
    ++count_.dropped;
    return true;
  }
  parties_.go_on_finishing(number, now());
  if (frame.kind == FrameKind::message) return deliver(number, frame.sequence, frame.payload);
  // Nothing of this life comes behind its end, whatever the daemons say.
  count_.missed += sequences_.missed_at_end(frame.life, frame.sequence);
  remove(number, "withdrawn");
  set_timer();
  return true;
}

bool SubscriberChannel::deliver(Parties::Number number, std::uint64_t sequence, std::span<const std::byte> payload) {
  Provider& provider = providers_.at(number);
  const Life life = parties_.at(number).life;
  std::uint64_t missed = 0;
  if (life != no_life) {
    const auto gap = sequences_.take(life, sequence);
    if (!gap) return true;
    missed = *gap;
  }
  count_.missed += missed;
  auto converted = convert(conversions_, provider.event.convert, payload, provider.event.via);
  if (!converted) {
    ++count_.dropped;
    if (!std::exchange(provider.was_told_of_conversion, true)) problem(converted.error());
    return true;
  }
  ++count_.received;
  if (inbox_.is_empty()) host_.on_message(number_);
  inbox_.put({life, sequence, missed, std::move(*converted)});
  if (inbox_.is_full()) pause(true);
  return !is_paused_;
}

void SubscriberChannel::say_hello() {
  bool has_stream = false;
  for (const auto& [number, provider] : providers_) {
    if (provider.way != Way::hello) continue;
    has_stream = true;
    say(provider, FrameKind::hello);
  }
  hello_.set(has_stream ? now() + hello_interval : base::never);
}

void SubscriberChannel::say(const Provider& provider, FrameKind kind) {
  const auto payload = life_payload(stated_life(provider.event.publication.attributes));
  const auto bytes = frame_bytes({kind, life_, 0, payload});
  const std::array parts{part(bytes)};
  // One that is lost is followed by the next.
  if (socket_.is_open()) [[maybe_unused]]
    const int error = send_datagram(socket_, provider.address, parts);
}

}  // namespace geminga::client
