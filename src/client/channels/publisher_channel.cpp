#include "client/channels/publisher_channel.hpp"

#include <utility>

#include "client/channels/tcp_outlet.hpp"
#include "client/channels/udp_outlet.hpp"
#include "client/protocol/life.hpp"

namespace geminga::client {
namespace {

/// Whether two events are equal but for the change and for the number that a daemon gave the service.
bool is_same(ConsumerEvent before, const ConsumerEvent& event) {
  before.change = event.change;
  before.subscription = event.subscription;
  return before == event;
}

}  // namespace

std::expected<std::unique_ptr<PublisherChannel>, std::string> PublisherChannel::open(ChannelHost& host,
                                                                                     ChannelNumber number,
                                                                                     NamedPublication& publication) {
  const Life life = new_life();
  publication.attributes.insert_or_assign(std::string(channel_attribute), to_string(life));
  if (publication.protocol == "udp") return UdpOutlet::open(host, number, life, publication);
  if (publication.protocol == "tcp") return TcpOutlet::open(host, number, life, publication);
  return std::unexpected("no channel over " + publication.protocol + ": there are udp and tcp");
}

PublisherChannel::PublisherChannel(ChannelHost& host, ChannelNumber number, Life life)
    : host_(host), number_(number), life_(life), sealer_(life, Direction::forward), timer_(host.reactor(), [this] {
        for (const auto over : counterparts_.expired(now())) remove(over, counterparts_.at(over).reason);
        set_timer();
      }) {}

void PublisherChannel::set_keys(ChannelKeys keys) {
  if (keys_ == keys) return;
  const bool sealed = seals();
  keys_ = std::move(keys);
  on_keys(seals() && !sealed);
  for (const auto& [number, consumer] : consumers_) {
    if (is_reached(number)) appear(number);
  }
}

bool PublisherChannel::lacks_life(Counterparts::Number consumer) const {
  return keys_ && !keys_->takes_plain() && counterparts_.at(consumer).life == no_life;
}

void PublisherChannel::tell_crowding(Crowding::News news, const Places& places, std::string_view kind) {
  if (news == Crowding::News::none) return;
  const std::string most = std::to_string(places.most());
  const bool is_full = news == Crowding::News::full;
  if (is_full) problem("all " + most + " places for " + std::string(kind) + " are taken");
  // An attribute cannot be taken back: 0 says that there are places again.
  host_.state_attribute(number_, "channel.full", is_full ? most : "0");
}

Result<void, SendError> PublisherChannel::send(std::span<const std::byte> payload) {
  if (is_closed_) return Failure(SendError{SendError::Kind::closed, "the publisher was withdrawn"});
  if (!host_.is_own_process()) {
    return Failure(SendError{SendError::Kind::closed, "this node belongs to another process"});
  }
  if (payload.size() > max_payload()) {
    const std::string limit = std::to_string(max_payload());
    return Failure(SendError{SendError::Kind::too_large,
                             max_payload() == max_datagram_payload
                                 ? "a message over UDP has at most " + limit + " octets: offer it with protocol=tcp"
                                 : "a message has at most " + limit + " octets"});
  }
  if (!keys_ || !has_consumer()) return {};
  ++count_.sent;
  ++sequence_;
  transmit(payload);
  return {};
}

void PublisherChannel::on_event(const ConsumerEvent& event) {
  const auto known = counterparts_.find(event.subscription);
  if (event.change == Change::del) {
    if (!known) return;
    // A daemon that is just back may have heard only of the choice of this publisher under its former number.
    if (event.reason == "outranked" && host_.is_settling()) {
      if (!counterparts_.lose_sight(*known, event.reason, carrier_of(*known), now())) remove(*known, event.reason);
      return set_timer();
    }
    // A consumer sends nothing, so there is nothing to wait for.
    const auto parted = counterparts_.del(event.subscription, event.reason, carrier_of(*known), now());
    const bool is_final = counterparts_.at(*known).state != Counterparts::State::orphaned;
    if (parted.parting != Counterparts::Parting::go_on) remove(*known, event.reason, is_final);
    return set_timer();
  }
  // A consumer that has ended comes back by an add only.
  if (event.change == Change::modify && !known) return;
  const Life life = stated_life(event.subscribed.attributes);
  if (known && counterparts_.at(*known).life != life &&
      !counterparts_.lose_sight(*known, "changed", carrier_of(*known), now())) {
    remove(*known, "changed");
  }
  const auto added = counterparts_.add(life, event.subscription);
  Consumer& consumer = consumers_[added.number];
  const bool is_news = consumer.was_told && !is_same(consumer.event, event);
  consumer.event = event;
  consumer.address = peer_address(event.subscribed.address, event.subscribed.port).value_or(PeerAddress{});
  if (is_news) tell(ConsumerChange::What::modified, added.number, "");
  on_consumer(added.number);
  if (lacks_life(added.number) && consumer.address.port != 0 && !std::exchange(consumer.was_told_of_life, true)) {
    problem(to_string(event.subscription) + " states no life, so its channel cannot be sealed");
  }
  if (is_reached(added.number)) appear(added.number);
  set_timer();
}

void PublisherChannel::on_settled() {
  for (const auto over : counterparts_.settle([this](auto consumer) { return carrier_of(consumer); }, now())) {
    remove(over, counterparts_.at(over).reason);
  }
  set_timer();
}

void PublisherChannel::on_refused() {
  while (!consumers_.empty()) remove(consumers_.begin()->first, Counterparts::refused_reason, true);
  set_timer();
}

void PublisherChannel::appear(Counterparts::Number consumer) {
  if (!std::exchange(consumers_.at(consumer).was_told, true)) tell(ConsumerChange::What::added, consumer, "");
}

void PublisherChannel::vanish(Counterparts::Number consumer, std::string_view reason) {
  const Counterparts::Counterpart& counterpart = counterparts_.at(consumer);
  if (counterpart.state == Counterparts::State::matched) {
    if (!std::exchange(consumers_.at(consumer).was_told, false)) return;
    return tell(ConsumerChange::What::removed, consumer, reason);
  }
  remove(consumer, counterpart.reason.empty() ? std::string(Counterparts::disconnected_reason) : counterpart.reason);
  set_timer();
}

void PublisherChannel::remove(Counterparts::Number consumer, std::string_view reason, bool is_final) {
  if (!counterparts_.contains(consumer)) return;
  const std::string kept(reason);  // it may belong to the counterpart, which is erased
  on_consumer_gone(consumer, is_final);
  if (consumers_.at(consumer).was_told) tell(ConsumerChange::What::removed, consumer, kept);
  counterparts_.erase(consumer);
  consumers_.erase(consumer);
}

void PublisherChannel::tell(ConsumerChange::What what, Counterparts::Number consumer, std::string_view reason) {
  if (is_closed_) return;
  host_.tell(ConsumerChange{number_, what, counterparts_.at(consumer).life, consumers_.at(consumer).event,
                            std::string(reason)});
}

}  // namespace geminga::client
