#include "client/channels/subscriber_channel.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "client/protocol/converter.hpp"
#include "client/protocol/life.hpp"

namespace geminga::client {
namespace {

/// Whether two events are equal but for the change and for the number that a daemon gave the service.
bool is_same(ServiceEvent before, const ServiceEvent& event) {
  before.change = event.change;
  before.service = event.service;
  return before == event;
}

}  // namespace

std::expected<std::unique_ptr<SubscriberChannel>, std::string> SubscriberChannel::open(ChannelHost& host,
                                                                                       ChannelNumber number,
                                                                                       NamedSubscription& subscription,
                                                                                       Conversions conversions) {
  const Life life = new_life();
  subscription.attributes.insert_or_assign(std::string(channel_attribute), to_string(life));
  if (subscription.protocols.empty()) subscription.protocols = {"udp", "tcp"};
  const std::uint32_t usual = subscription.mode == ChannelMode::one_to_one ? 1 : 0;
  std::unique_ptr<SubscriberChannel> made(
      new SubscriberChannel(host, number, life, subscription.limit.value_or(usual), std::move(conversions)));
  if (std::ranges::find(subscription.protocols, "udp") != subscription.protocols.end()) {
    const auto port = made->udp_.open(subscription.address, subscription.port);
    if (!port) return std::unexpected(port.error());
    subscription.port = *port;
  }
  return made;
}

SubscriberChannel::SubscriberChannel(ChannelHost& host, ChannelNumber number, Life life, std::uint32_t limit,
                                     Conversions conversions)
    : host_(host),
      number_(number),
      life_(life),
      limit_(limit),
      conversions_(std::move(conversions)),
      udp_(host, life, told_by_udp()),
      timer_(host.reactor(), [this] {
        for (const auto over : counterparts_.expired(now())) {
          if (is_paused_) counterparts_.go_on_finishing(over, now());  // it was not read
          if (counterparts_.at(over).until <= now()) remove(over, counterparts_.at(over).reason);
        }
        set_timer();
      }) {}

UdpInlet::Told SubscriberChannel::told_by_udp() {
  UdpInlet::Told told;
  told.frame = [this](Number number, const Frame& frame) { take_frame(number, frame); };
  told.plain = [this](Number number, std::span<const std::byte> payload) { deliver(number, 0, payload); };
  told.dropped = [this] { ++count_.dropped; };
  told.found = [this] { --count_.dropped; };
  told.problem = [this](const std::string& text) { problem(text); };
  return told;
}

std::optional<Message> SubscriberChannel::take() {
  auto message = inbox_.take();
  if (message && is_paused_ && !inbox_.is_full()) pause(false);
  return message;
}

void SubscriberChannel::pause(bool is_paused) {
  if (is_paused_ == is_paused) return;
  is_paused_ = is_paused;
  // pause() gives the frames that a connection has read already, which may end it or fill the inbox again.
  std::vector<Number> numbers;
  for (const auto& [number, provider] : providers_) {
    if (provider.connection) numbers.push_back(number);
  }
  for (const auto number : numbers) {
    const auto found = providers_.find(number);
    if (found != providers_.end() && found->second.connection) found->second.connection->pause(is_paused_);
  }
}

void SubscriberChannel::on_event(const ServiceEvent& event) {
  const auto known = counterparts_.find(event.service);
  if (event.change == Change::del) {
    if (!known) return;
    const auto parted = counterparts_.del(event.service, event.reason, carrier_of(*known), now());
    if (parted.parting == Counterparts::Parting::close) remove(parted.number, event.reason);
    if (parted.parting == Counterparts::Parting::finish && providers_.at(parted.number).way != Way::connection) {
      udp_.read_all(parted.number);
      remove(parted.number, event.reason);
    }
    remove_superfluous();
    return set_timer();
  }
  // A provider that has ended comes back by an add only.
  if (event.change == Change::modify && !known) return;
  const Life life = stated_life(event.publication.attributes);
  if (known && counterparts_.at(*known).life != life) remove(*known, "changed");
  const auto added = counterparts_.add(life, event.service);
  if (added.is_new) {
    providers_.emplace(added.number, Provider{event, Way::none, {}});
    tell(ProviderChange::What::added, added.number, "");
  } else {
    const bool was_same = is_same(providers_.at(added.number).event, event);
    providers_.at(added.number).event = event;
    if (!was_same) tell(ProviderChange::What::modified, added.number, "");
  }
  wire(added.number, event);
  remove_superfluous();
  set_timer();
}

void SubscriberChannel::on_settled() {
  for (const auto over : counterparts_.settle([this](auto number) { return carrier_of(number); }, now())) {
    remove(over, counterparts_.at(over).reason);
  }
  remove_superfluous();
  set_timer();
}

void SubscriberChannel::on_refused() {
  while (!providers_.empty()) remove(providers_.begin()->first, Counterparts::refused_reason);
  set_timer();
}

void SubscriberChannel::remove_superfluous() {
  for (const auto orphan : counterparts_.superfluous(limit_)) remove(orphan, counterparts_.at(orphan).reason);
}

Counterparts::Carrier SubscriberChannel::carrier_of(Number number) const {
  const Provider& provider = providers_.at(number);
  if (provider.way == Way::none) return Counterparts::Carrier::no_connection;
  if (provider.way != Way::connection) return Counterparts::Carrier::datagrams;
  return provider.connection && provider.connection->is_connected() ? Counterparts::Carrier::connection
                                                                    : Counterparts::Carrier::no_connection;
}

void SubscriberChannel::remove(Number number, std::string_view reason) {
  const auto found = providers_.find(number);
  if (found == providers_.end()) return;
  const std::string kept(reason);  // it may belong to the counterpart, which is erased
  sequence_.interrupt(counterparts_.at(number).life);
  udp_.forget(number);
  tell(ProviderChange::What::removed, number, kept);
  counterparts_.erase(number);
  providers_.erase(number);
}

void SubscriberChannel::tell(ProviderChange::What what, Number number, std::string_view reason) {
  host_.tell(
      ProviderChange{number_, what, counterparts_.at(number).life, providers_.at(number).event, std::string(reason)});
}

void SubscriberChannel::wire(Number number, const ServiceEvent& event) {
  Provider& provider = providers_.at(number);
  const NamedPublication& offer = event.publication;
  const Life life = counterparts_.at(number).life;
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

  udp_.forget(number);
  provider.connection.reset();
  provider.way = way;
  provider.address = address.value_or(PeerAddress{});
  if (way == Way::datagrams || way == Way::hello) {
    udp_.hear(number, life, provider.address, way == Way::hello);
    udp_.deliver_early(number);
  } else if (way == Way::group) {
    udp_.join(number, life, provider.address);
  } else if (way == Way::connection) {
    connect(number);
  }
}

void SubscriberChannel::connect(Number number) {
  Provider& provider = providers_.at(number);
  TcpInlet::Told told;
  told.frame = [this, number](const Frame& frame) { return take_frame(number, frame); };
  told.lost = [this, number] { return on_lost(number); };
  told.broken = [this] { ++count_.dropped; };
  provider.connection = std::make_unique<TcpInlet>(host_.reactor(), provider.address, life_, std::move(told));
  if (is_paused_) provider.connection->pause(true);
  provider.connection->start();
}

bool SubscriberChannel::on_lost(Number number) {
  const Counterparts::Counterpart& counterpart = counterparts_.at(number);
  if (counterpart.state == Counterparts::State::matched) return true;
  if (counterpart.state == Counterparts::State::doubted) {
    remove(number, Counterparts::disconnected_reason);
    return false;
  }
  remove(number, counterpart.reason);
  set_timer();
  return false;
}

bool SubscriberChannel::take_frame(Number number, const Frame& frame) {
  if (frame.life != counterparts_.at(number).life || frame.kind == FrameKind::hello) {
    ++count_.dropped;
    return true;
  }
  counterparts_.go_on_finishing(number, now());
  if (frame.kind == FrameKind::message) {
    deliver(number, frame.sequence, frame.payload);
    return !is_paused_;
  }
  // No message of this life comes after its end, whatever the daemons say.
  count_.missed += sequence_.missed_at_end(frame.life, frame.sequence);
  remove(number, "withdrawn");
  set_timer();
  return true;
}

void SubscriberChannel::deliver(Number number, std::uint64_t sequence, std::span<const std::byte> payload) {
  Provider& provider = providers_.at(number);
  const Life life = counterparts_.at(number).life;
  std::uint64_t missed = 0;
  if (life != no_life) {
    const auto gap = sequence_.take(life, sequence);
    if (!gap) return;
    missed = *gap;
  }
  count_.missed += missed;
  auto converted = convert(conversions_, provider.event.convert, payload, provider.event.via);
  if (!converted) {
    ++count_.dropped;
    if (!std::exchange(provider.was_told_of_conversion, true)) problem(converted.error());
    return;
  }
  ++count_.received;
  if (inbox_.is_empty()) host_.on_message(number_);
  Message message{life, sequence, missed, std::move(*converted)};
  if (provider.way == Way::connection) {
    inbox_.put_streamed(std::move(message));
  } else {
    const std::size_t lost = inbox_.put_datagram(std::move(message));
    count_.received -= lost;
    count_.missed += lost;
  }
  if (inbox_.is_full()) pause(true);
}

}  // namespace geminga::client
