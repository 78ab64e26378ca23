#include "client/channels/publisher_channel.hpp"

#include <utility>

#include "client/channels/life.hpp"
#include "client/channels/tcp_publisher.hpp"
#include "client/channels/udp_publisher.hpp"

namespace geminga::client {
namespace {

/// Whether two events say the same but for who says it in the words of daemons that come and go.
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
  if (publication.protocol == "udp") return UdpPublisher::open(host, number, life, publication);
  if (publication.protocol == "tcp") return TcpPublisher::open(host, number, life, publication);
  return std::unexpected("no channel over " + publication.protocol + ": there are udp and tcp");
}

PublisherChannel::PublisherChannel(ChannelHost& host, ChannelNumber number, Life life)
    : host_(host), number_(number), life_(life), timer_(host.reactor(), [this] {
        for (const auto over : parties_.expired(now())) remove(over, parties_.at(over).reason);
        set_timer();
      }) {}

Result<void, SendError> PublisherChannel::send(std::span<const std::byte> payload) {
  if (is_closed_) return Failure(SendError{SendError::Kind::closed, "the publisher was withdrawn"});
  if (payload.size() > max_payload()) {
    const std::string limit = std::to_string(max_payload());
    return Failure(SendError{SendError::Kind::too_large,
                             max_payload() == max_datagram_payload
                                 ? "a message over UDP has at most " + limit + " octets: offer it with protocol=tcp"
                                 : "a message has at most " + limit + " octets"});
  }
  if (!has_consumer()) return {};
  ++count_.sent;
  transmit(frame_header(FrameKind::message, life_, ++sequence_, payload.size()), payload);
  return {};
}

void PublisherChannel::on_event(const ConsumerEvent& event) {
  const auto known = parties_.find(event.subscription);
  if (event.change == Change::del) {
    if (!known) return;
    // Nothing comes from a consumer, so nothing is waited for.
    const auto parted = parties_.del(event.subscription, event.reason, carrier_of(*known), now());
    const bool is_final = parties_.at(*known).state != Parties::State::orphaned;
    if (parted.parting != Parties::Parting::go_on) remove(*known, event.reason, is_final);
    return set_timer();
  }
  // What has ended is made again by an add only.
  if (event.change == Change::modify && !known) return;
  const Life life = stated_life(event.subscribed.attributes);
  if (known && parties_.at(*known).life != life) remove(*known, "changed", true);
  const auto added = parties_.add(life, event.subscription);
  Consumer& consumer = consumers_[added.number];
  const bool is_news = consumer.was_told && !is_same(consumer.event, event);
  consumer.event = event;
  consumer.address = peer_address(event.subscribed.address, event.subscribed.port).value_or(PeerAddress{});
  if (is_news) tell(ConsumerChange::What::modified, added.number, "");
  on_consumer(added.number);
  if (is_reached(added.number)) appear(added.number);
  set_timer();
}

void PublisherChannel::on_settled() {
  for (const auto over : parties_.settle([this](auto consumer) { return carrier_of(consumer); }, now())) {
    remove(over, parties_.at(over).reason);
  }
  set_timer();
}

void PublisherChannel::on_refused() {
  while (!consumers_.empty()) remove(consumers_.begin()->first, Parties::refused_reason, true);
  set_timer();
}

void PublisherChannel::appear(Parties::Number consumer) {
  if (!std::exchange(consumers_.at(consumer).was_told, true)) tell(ConsumerChange::What::added, consumer, "");
}

void PublisherChannel::vanish(Parties::Number consumer) {
  const Parties::Party& party = parties_.at(consumer);
  if (party.state == Parties::State::matched) {
    if (!std::exchange(consumers_.at(consumer).was_told, false)) return;
    return tell(ConsumerChange::What::removed, consumer, Parties::lost_reason);
  }
  remove(consumer, party.reason.empty() ? std::string(Parties::disconnected_reason) : party.reason);
  set_timer();
}

void PublisherChannel::remove(Parties::Number consumer, std::string_view reason, bool is_final) {
  if (!parties_.contains(consumer)) return;
  const std::string kept(reason);  // it may be the party's own
  on_consumer_gone(consumer, is_final);
  if (consumers_.at(consumer).was_told) tell(ConsumerChange::What::removed, consumer, kept);
  parties_.erase(consumer);
  consumers_.erase(consumer);
}

void PublisherChannel::tell(ConsumerChange::What what, Parties::Number consumer, std::string_view reason) {
  if (is_closed_) return;
  host_.tell(
      ConsumerChange{number_, what, parties_.at(consumer).life, consumers_.at(consumer).event, std::string(reason)});
}

}  // namespace geminga::client
