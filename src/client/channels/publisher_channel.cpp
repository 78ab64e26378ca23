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
        for (const auto consumer : parties_.expired(now())) remove(consumer);
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
  if (event.change == Change::del) {
    const auto known = parties_.find(event.subscription);
    if (!known) return;
    // Nothing comes from a consumer, so nothing is waited for.
    const auto parted = parties_.del(event.subscription, event.reason, carrier_of(*known), now());
    if (parted.parting != Parties::Parting::go_on) remove(parted.number);
    return set_timer();
  }
  const Life life = stated_life(event.subscribed.attributes);
  if (const auto known = parties_.find(event.subscription); known && parties_.at(*known).life != life) remove(*known);
  const auto added = parties_.add(life, event.subscription);
  const auto address = peer_address(event.subscribed.address, event.subscribed.port).value_or(PeerAddress{});
  const bool was_same = !added.is_new && is_same(consumers_.at(added.number).event, event);
  consumers_.insert_or_assign(added.number, Consumer{event, address});
  if (added.is_new) {
    tell(ConsumerChange::What::added, added.number, "");
  } else if (!was_same) {
    tell(ConsumerChange::What::modified, added.number, "");
  }
  on_consumer(added.number);
  set_timer();
}

void PublisherChannel::on_settled() {
  for (const auto over : parties_.settle([this](auto consumer) { return carrier_of(consumer); }, now())) remove(over);
  set_timer();
}

void PublisherChannel::remove(Parties::Number consumer) {
  if (!parties_.contains(consumer)) return;
  on_consumer_gone(consumer);
  tell(ConsumerChange::What::removed, consumer, parties_.at(consumer).reason);
  parties_.erase(consumer);
  consumers_.erase(consumer);
}

void PublisherChannel::tell(ConsumerChange::What what, Parties::Number consumer, const std::string& reason) {
  if (is_closed_) return;
  host_.tell(ConsumerChange{number_, what, parties_.at(consumer).life, consumers_.at(consumer).event, reason});
}

}  // namespace geminga::client
