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
      sealer_(life, Direction::back),
      limit_(limit),
      conversions_(std::move(conversions)),
      udp_(host, sealer_, told_by_udp()),
      timer_(host.reactor(),
             [this] {
               for (const auto over : counterparts_.expired(now())) {
                 if (is_paused_) counterparts_.go_on_finishing(over, now());  // it was not read
                 if (counterparts_.at(over).until <= now()) remove(over, counterparts_.at(over).reason);
               }
               set_timer();
             }),
      place_timer_(host.reactor(), [this] { rotate_places(); }),
      again_timer_(host.reactor(), [this] { return_to_ended(); }) {}

UdpInlet::Told SubscriberChannel::told_by_udp() {
  UdpInlet::Told told;
  told.frame = [this](Number number, const Frame& frame, bool is_proved) { take_frame(number, frame, is_proved); };
  told.plain = [this](Number number, std::span<const std::byte> payload) {
    deliver(number, {FrameKind::message, no_life, 0, payload}, false);
  };
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
  if (event.change == Change::del) {
    on_del(event);
  } else {
    on_add(event);
  }
  remove_superfluous();
  set_timer();
}

void SubscriberChannel::on_del(const ServiceEvent& event) {
  ended_.erase(event.service);
  const auto known = counterparts_.find(event.service);
  if (!known) return;
  const auto parted = counterparts_.del(event.service, event.reason, carrier_of(*known), now());
  const Provider& provider = providers_.at(parted.number);
  if (parted.parting == Counterparts::Parting::close) return remove(parted.number, event.reason);
  if (provider.way == Way::connection) return;
  const bool has_said_end = provider.end_until > now();
  const std::uint64_t last = provider.last_at_end;
  if (parted.parting != Counterparts::Parting::finish && !has_said_end) return;
  udp_.read_all(parted.number);
  if (!counterparts_.contains(parted.number)) return;
  if (has_said_end) count_missed_at_end(parted.number, last, false);
  remove(parted.number, "withdrawn");
}

void SubscriberChannel::on_add(const ServiceEvent& event) {
  const auto known = counterparts_.find(event.service);
  if (const auto ended = ended_.find(event.service); ended != ended_.end()) {
    if (event.change == Change::modify) {
      ended->second.event = event;
    } else {
      ended_.erase(ended);
    }
  }
  // A provider that has ended comes back by an add only.
  if (event.change == Change::modify && !known) return;
  const Life life = stated_life(event.publication.attributes);
  // The former life may only have got another number from its daemon, which tells so soon.
  if (known && counterparts_.at(*known).life != life &&
      !counterparts_.lose_sight(*known, "changed", carrier_of(*known), now())) {
    remove(*known, "changed");
  }
  const auto added = counterparts_.add(life, event.service);
  if (added.is_new) {
    providers_.emplace(added.number, Provider{event, Way::none, {}});
    tell(ProviderChange::What::added, added.number, "");
  } else {
    Provider& provider = providers_.at(added.number);
    const bool was_same = is_same(provider.event, event);
    provider.event = event;
    provider.end_until = {};  // it is there
    if (!was_same) tell(ProviderChange::What::modified, added.number, "");
  }
  wire(added.number, event);
}

void SubscriberChannel::on_daemon_gone() {
  counterparts_.doubt();
  ended_.clear();
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
  leave_place(number);
  keep_keys(counterparts_.at(number).life);
  tell(ProviderChange::What::removed, number, kept);
  counterparts_.erase(number);
  providers_.erase(number);
}

void SubscriberChannel::tell(ProviderChange::What what, Number number, std::string_view reason) {
  host_.tell(
      ProviderChange{number_, what, counterparts_.at(number).life, providers_.at(number).event, std::string(reason)});
}

SubscriberChannel::Way SubscriberChannel::way_of(Number number, const ServiceEvent& event,
                                                 const std::optional<PeerAddress>& address) {
  const NamedPublication& offer = event.publication;
  const Life life = counterparts_.at(number).life;
  const std::string name = to_string(event.service);
  const bool is_stream = offer.mode == ChannelMode::one_to_many_stream;
  if (!address) {
    problem_of(number, "the provider " + name + " has no address that can be reached");
  } else if (life == no_life && host_.sealing_mode() > SealingMode::mixed) {
    problem_of(number, name + " states no life, so its channel cannot be sealed");
  } else if (offer.protocol == "udp") {
    if (life == no_life && !host_.sealing_mode()) return Way::none;  // not known yet
    return is_stream && address->is_multicast() ? Way::group : is_stream ? Way::hello : Way::datagrams;
  } else if (offer.protocol == "tcp" && life != no_life) {
    return Way::connection;
  } else {
    problem_of(number, "no channel to the provider " + name +
                           (offer.protocol == "tcp" ? ": it states no life" : ": it speaks " + offer.protocol));
  }
  return Way::none;
}

void SubscriberChannel::wire(Number number, const ServiceEvent& event) {
  Provider& provider = providers_.at(number);
  const Life life = counterparts_.at(number).life;
  const auto address = peer_address(event.publication.address, event.publication.port);
  Way way = way_of(number, event, address);
  const auto keys = life == no_life ? ChannelKeys() : keys_of(life);
  if (!keys) way = Way::none;  // until the daemon has told them
  if (way == provider.way && (way == Way::none || *address == provider.address)) return;

  udp_.forget(number);
  leave_place(number);
  provider.connection.reset();
  provider.way = way;
  provider.address = address.value_or(PeerAddress{});
  if (way == Way::datagrams || way == Way::hello) {
    udp_.hear(number, life, provider.address, *keys, way == Way::hello);
    udp_.deliver_early(number);
  } else if (way == Way::group) {
    udp_.join(number, life, provider.address, *keys);
  } else if (way == Way::connection) {
    claim_place(number);
  }
}

void SubscriberChannel::connect(Number number) {
  Provider& provider = providers_.at(number);
  const Life life = counterparts_.at(number).life;
  TcpInlet::Told told;
  told.frame = [this, number](const Frame& frame, bool is_proved) { return take_frame(number, frame, is_proved); };
  told.lost = [this, number] { return on_lost(number); };
  told.dropped = [this] { ++count_.dropped; };
  told.full = [this, address = to_string(provider.address)] {
    problem("the provider " + address + " has no place for another consumer");
  };
  provider.connection = std::make_unique<TcpInlet>(host_, provider.address, sealer_, life,
                                                   keys_of(life).value_or(ChannelKeys()), std::move(told));
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

bool SubscriberChannel::take_frame(Number number, const Frame& frame, bool is_proved) {
  counterparts_.go_on_finishing(number, now());
  if (frame.kind == FrameKind::message) {
    deliver(number, frame, is_proved);
    return !is_paused_;
  }
  take_end(number, frame, is_proved);
  set_timer();
  return true;
}

void SubscriberChannel::take_end(Number number, const Frame& frame, bool is_proved) {
  Provider& provider = providers_.at(number);
  const Counterparts::Counterpart& counterpart = counterparts_.at(number);
  const bool is_matched = counterpart.state == Counterparts::State::matched;
  if (provider.way != Way::connection && !is_proved) {
    // Anybody can forge it: it counts if the daemon says the same.
    provider.last_at_end = frame.sequence;
    provider.end_until = now() + end_patience;
    if (is_matched || counterpart.state == Counterparts::State::doubted) return;
  }
  // No message of this life comes after its end, whatever the daemons say.
  count_missed_at_end(number, frame.sequence, is_proved || provider.way == Way::connection);
  if (is_matched && provider.way == Way::connection) {
    ended_.insert_or_assign(counterpart.key, Ended{provider.event, now() + again_patience});
    if (again_timer_.at() == base::never) again_timer_.set(now() + again_patience);
  }
  remove(number, "withdrawn");
}

void SubscriberChannel::count_missed_at_end(Number number, std::uint64_t last, bool is_proved) {
  const std::uint64_t missed = sequence_.missed_at_end(counterparts_.at(number).life, last);
  if (is_proved || missed <= max_sequence_step) count_.missed += missed;
}

void SubscriberChannel::deliver(Number number, const Frame& frame, bool is_proved) {
  Provider& provider = providers_.at(number);
  const Life life = frame.life;
  const std::uint64_t sequence = frame.sequence;
  const std::span<const std::byte> payload = frame.payload;
  std::uint64_t missed = 0;
  if (life != no_life) {
    const auto gap = is_proved || provider.way == Way::connection ? sequence_.take(life, sequence)
                                                                  : sequence_.take_unproved(life, sequence, now());
    if (!gap) return;
    missed = *gap;
  }
  if (provider.way == Way::connection && !std::exchange(provider.is_served, true)) places_.serve(number);
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
