#include "client/channels/subscriber_channel.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "client/channels/life.hpp"

namespace geminga::client {
namespace {

/// Whether two events say the same but for who says it in the words of daemons that come and go.
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
    auto socket = open_datagrams({subscription.address, subscription.port});
    if (!socket) return std::unexpected(std::move(socket.error().text));
    made->socket_ = std::move(*socket);
    subscription.port = port_of(made->socket_);
    made->watch_socket();
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
      timer_(host.reactor(),
             [this] {
               for (const auto over : parties_.expired(now())) {
                 if (is_paused_) parties_.go_on_finishing(over, now());  // it was not read from
                 if (parties_.at(over).until <= now()) remove(over, parties_.at(over).reason);
               }
               set_timer();
             }),
      hello_(host.reactor(), [this] { say_hello(); }),
      interfaces_(host.reactor(), [this] { join_all(); }) {}

SubscriberChannel::~SubscriberChannel() {
  for (const auto& [number, provider] : providers_) {
    if (provider.way == Way::hello) say(provider, FrameKind::end);
  }
}

void SubscriberChannel::watch_socket() {
  watch_ = host_.reactor().watch(socket_, [this](Reactor::Ready) { read(socket_, std::nullopt); });
}

std::optional<Message> SubscriberChannel::take() {
  auto message = inbox_.take();
  if (message && is_paused_ && !inbox_.is_full()) pause(false);
  return message;
}

void SubscriberChannel::pause(bool is_paused) {
  if (is_paused_ == is_paused) return;
  is_paused_ = is_paused;
  watch_.want(!is_paused, false);
  for (auto& [number, provider] : providers_) provider.group_watch.want(!is_paused, false);
  // What a connection has read already is given within the call, and may end it, or fill the inbox again.
  std::vector<Parties::Number> numbers;
  for (const auto& [number, provider] : providers_) {
    if (provider.connection) numbers.push_back(number);
  }
  for (const auto number : numbers) {
    const auto found = providers_.find(number);
    if (found != providers_.end() && found->second.connection) found->second.connection->pause(is_paused_);
  }
}

void SubscriberChannel::on_event(const ServiceEvent& event) {
  const auto known = parties_.find(event.service);
  if (event.change == Change::del) {
    if (!known) return;
    const auto parted = parties_.del(event.service, event.reason, carrier_of(*known), now());
    if (parted.parting == Parties::Parting::close) remove(parted.number, event.reason);
    if (parted.parting == Parties::Parting::finish && providers_.at(parted.number).way != Way::connection) {
      // What the socket holds comes still.
      if (Provider& provider = providers_.at(parted.number); provider.way == Way::group) {
        read(provider.group, parted.number);
      } else {
        read(socket_, std::nullopt);
      }
      if (!is_paused_) remove(parted.number, event.reason);
    }
    remove_superfluous();
    return set_timer();
  }
  // What has ended is made again by an add only.
  if (event.change == Change::modify && !known) return;
  const Life life = stated_life(event.publication.attributes);
  if (known && parties_.at(*known).life != life) remove(*known, "changed");
  const auto added = parties_.add(life, event.service);
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
  for (const auto over : parties_.settle([this](auto number) { return carrier_of(number); }, now())) {
    remove(over, parties_.at(over).reason);
  }
  remove_superfluous();
  set_timer();
}

void SubscriberChannel::on_refused() {
  while (!providers_.empty()) remove(providers_.begin()->first, Parties::refused_reason);
  set_timer();
}

void SubscriberChannel::remove_superfluous() {
  for (const auto orphan : parties_.superfluous(limit_)) remove(orphan, parties_.at(orphan).reason);
}

Parties::Carrier SubscriberChannel::carrier_of(Parties::Number number) const {
  const Provider& provider = providers_.at(number);
  if (provider.way == Way::none) return Parties::Carrier::no_connection;
  if (provider.way != Way::connection) return Parties::Carrier::datagrams;
  return provider.connection && provider.connection->is_connected() ? Parties::Carrier::connection
                                                                    : Parties::Carrier::no_connection;
}

void SubscriberChannel::remove(Parties::Number number, std::string_view reason) {
  const auto found = providers_.find(number);
  if (found == providers_.end()) return;
  const std::string kept(reason);  // it may be the party's own
  sequences_.interrupt(parties_.at(number).life);
  Provider& provider = found->second;
  // A publisher that is there still is told that nobody listens any more.
  if (provider.way == Way::hello) say(provider, FrameKind::end);
  const auto address = by_address_.find(provider.address);
  if (address != by_address_.end() && address->second == number) by_address_.erase(address);
  tell(ProviderChange::What::removed, number, kept);
  parties_.erase(number);
  providers_.erase(number);
}

void SubscriberChannel::tell(ProviderChange::What what, Parties::Number number, std::string_view reason) {
  host_.tell(ProviderChange{number_, what, parties_.at(number).life, providers_.at(number).event, std::string(reason)});
}

}  // namespace geminga::client
