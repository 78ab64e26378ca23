#include "client/channels/subscriber_channel.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "client/protocol/life.hpp"
#include "client/protocol/limits.hpp"

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
      keys_([this](Life publisher) { return counterparts_.find(publisher).has_value(); }),
      delivery_(std::move(conversions)),
      ended_(host.reactor(), [this](const ServiceEvent& event) { on_event(event); }),
      udp_(host, sealer_, told_by_udp()),
      tcp_(host, sealer_, told_by_tcp()),
      timer_(host.reactor(), [this] { expire(); }) {}

UdpInlet::Told SubscriberChannel::told_by_udp() {
  UdpInlet::Told told;
  told.frame = [this](Number number, const Frame& frame, bool is_proved) { take_frame(number, frame, is_proved); };
  told.plain = [this](Number number, std::span<const std::byte> payload) {
    deliver(number, {FrameKind::message, no_life, 0, payload}, Delivery::Carrier::forgeable);
  };
  told.dropped = [this] { delivery_.count_dropped(); };
  told.found = [this] { delivery_.uncount_dropped(); };
  told.problem = [this](const std::string& text) { problem(text); };
  return told;
}

TcpInlets::Told SubscriberChannel::told_by_tcp() {
  TcpInlets::Told told;
  told.frame = [this](Number number, const Frame& frame, bool is_proved) { take_frame(number, frame, is_proved); };
  told.lost = [this](Number number) { return on_lost(number); };
  told.dropped = [this] { delivery_.count_dropped(); };
  told.problem = [this](const std::string& text) { problem(text); };
  return told;
}

std::optional<Message> SubscriberChannel::take() {
  auto message = delivery_.take();
  if (message && tcp_.is_paused() && !delivery_.is_full()) tcp_.pause(false);
  return message;
}

void SubscriberChannel::set_keys(Life publisher, const ChannelKeys& keys) {
  keys_.put(publisher, keys);
  use_keys(publisher);
}

void SubscriberChannel::on_daemon_keys(bool has_keys) {
  keys_.on_daemon(has_keys);
  if (has_keys) return;
  std::vector<Life> lives;
  for (const auto& [number, counterpart] : counterparts_.all()) {
    if (counterpart.life != no_life) lives.push_back(counterpart.life);
  }
  for (const Life life : lives) use_keys(life);
}

void SubscriberChannel::on_mode() {
  std::vector<Number> lifeless;
  for (const auto& [number, counterpart] : counterparts_.all()) {
    if (counterpart.life == no_life) lifeless.push_back(number);
  }
  for (const Number number : lifeless) wire(number);
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
  ended_.forget(event.service);
  const auto known = counterparts_.find(event.service);
  if (!known) return;
  const auto parted = counterparts_.del(event.service, event.reason, carrier_of(*known), now());
  const Provider& provider = providers_.at(parted.number);
  if (parted.parting == Counterparts::Parting::close) return remove(parted.number, event.reason);
  if (provider.way == Way::connection) return;
  const SaidEnd end = provider.said_end;
  const bool has_said_end = end.until > now();
  if (parted.parting != Counterparts::Parting::finish && !has_said_end) return;
  udp_.read_all(parted.number);
  if (!counterparts_.contains(parted.number)) return;
  if (has_said_end) {
    delivery_.count_missed_at_end(counterparts_.at(parted.number).life, end.last, Delivery::Carrier::forgeable);
  }
  remove(parted.number, "withdrawn");
}

void SubscriberChannel::on_add(const ServiceEvent& event) {
  const auto known = counterparts_.find(event.service);
  if (event.change == Change::modify) {
    ended_.modify(event);
  } else {
    ended_.forget(event.service);
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
    providers_.emplace(added.number, Provider{event});
    tell(ProviderChange::What::added, added.number, "");
  } else {
    Provider& provider = providers_.at(added.number);
    const bool was_same = is_same(provider.event, event);
    provider.event = event;
    provider.said_end = {};  // it is there
    if (!was_same) tell(ProviderChange::What::modified, added.number, "");
  }
  wire(added.number);
}

void SubscriberChannel::on_daemon_gone() {
  counterparts_.doubt();
  ended_.forget_all();
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

void SubscriberChannel::expire() {
  for (const auto over : counterparts_.expired(now())) {
    if (tcp_.is_paused()) counterparts_.go_on_finishing(over, now());  // it was not read
    if (counterparts_.at(over).until <= now()) remove(over, counterparts_.at(over).reason);
  }
  set_timer();
}

void SubscriberChannel::remove_superfluous() {
  for (const auto orphan : counterparts_.superfluous(limit_)) remove(orphan, counterparts_.at(orphan).reason);
}

Counterparts::Carrier SubscriberChannel::carrier_of(Number number) const {
  const Provider& provider = providers_.at(number);
  if (provider.way == Way::none) return Counterparts::Carrier::no_connection;
  if (provider.way != Way::connection) return Counterparts::Carrier::datagrams;
  return tcp_.is_connected(number) ? Counterparts::Carrier::connection : Counterparts::Carrier::no_connection;
}

void SubscriberChannel::remove(Number number, std::string_view reason) {
  if (!providers_.contains(number)) return;
  const std::string kept(reason);  // it may belong to the counterpart, which is erased
  const Life life = counterparts_.at(number).life;
  delivery_.interrupt(life);
  udp_.forget(number);
  tcp_.close(number);
  keys_.leave(life);
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

void SubscriberChannel::wire(Number number) {
  Provider& provider = providers_.at(number);
  const Life life = counterparts_.at(number).life;
  const auto address = peer_address(provider.event.publication.address, provider.event.publication.port);
  const auto keys = keys_.of(life);
  Way way = way_of(number, provider.event, address);
  if (!keys) way = Way::none;  // until the daemon has told them
  if (way == provider.way && (way == Way::none || *address == provider.address)) return;

  udp_.forget(number);
  tcp_.close(number);
  provider.way = way;
  provider.address = address.value_or(PeerAddress{});
  if (way == Way::datagrams || way == Way::hello) {
    udp_.hear(number, life, provider.address, *keys, way == Way::hello);
    udp_.deliver_early(number);
  } else if (way == Way::group) {
    udp_.join(number, life, provider.address, *keys);
  } else if (way == Way::connection) {
    tcp_.open(number, life, provider.address, *keys);
  }
}

void SubscriberChannel::use_keys(Life publisher) {
  const auto number = counterparts_.find(publisher);
  const auto keys = keys_.of(publisher);
  if (!number || !keys) return;
  if (providers_.at(*number).way == Way::none) return wire(*number);
  udp_.set_keys(*number, *keys);
  tcp_.set_keys(*number, *keys);
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

void SubscriberChannel::take_frame(Number number, const Frame& frame, bool is_proved) {
  counterparts_.go_on_finishing(number, now());
  const bool is_streamed = providers_.at(number).way == Way::connection;
  const auto carrier = is_streamed ? Delivery::Carrier::stream
                       : is_proved ? Delivery::Carrier::proved
                                   : Delivery::Carrier::forgeable;
  if (frame.kind == FrameKind::message) return deliver(number, frame, carrier);
  take_end(number, frame, carrier);
  set_timer();
}

void SubscriberChannel::take_end(Number number, const Frame& frame, Delivery::Carrier carrier) {
  Provider& provider = providers_.at(number);
  const Counterparts::Counterpart& counterpart = counterparts_.at(number);
  const bool is_matched = counterpart.state == Counterparts::State::matched;
  if (carrier == Delivery::Carrier::forgeable) {
    provider.said_end = {frame.sequence, now() + end_patience};
    if (is_matched || counterpart.state == Counterparts::State::doubted) return;
  }
  // No message of this life comes after its end, whatever the daemons say.
  delivery_.count_missed_at_end(counterpart.life, frame.sequence, carrier);
  if (is_matched && carrier == Delivery::Carrier::stream) ended_.keep(provider.event);
  remove(number, "withdrawn");
}

void SubscriberChannel::deliver(Number number, const Frame& frame, Delivery::Carrier carrier) {
  Provider& provider = providers_.at(number);
  const bool was_empty = delivery_.is_empty();
  const auto is_new = delivery_.deliver(frame, carrier, provider.event, now());
  if (is_new && !*is_new) return;
  if (carrier == Delivery::Carrier::stream) tcp_.serve(number);
  if (!is_new) {
    if (!std::exchange(provider.was_told_of_conversion, true)) problem(is_new.error());
    return;
  }
  if (was_empty) host_.on_message(number_);
  if (delivery_.is_full()) tcp_.pause(true);
}

void SubscriberChannel::problem_of(Number number, const std::string& text) {
  if (std::exchange(providers_.at(number).last_problem, text) != text) problem(text);
}

}  // namespace geminga::client
