#include "client/channels/udp_outlet.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace geminga::client {
namespace {

/// Datagrams of one socket before other sockets have their turn.
constexpr int datagrams_at_once = 64;
/// Payloads up to this size are copied behind their header, because the system takes one piece faster than two.
constexpr std::size_t max_copied_payload = 8 * 1024;

}  // namespace

std::expected<std::unique_ptr<PublisherChannel>, std::string> UdpOutlet::open(ChannelHost& host, ChannelNumber number,
                                                                              Life life,
                                                                              NamedPublication& publication) {
  std::unique_ptr<UdpOutlet> made(new UdpOutlet(host, number, life, publication));
  if (auto opened = made->open_socket(); !opened) return std::unexpected(std::move(opened.error()));
  publication.port = made->binding_.port;
  // The port is known; the socket opens with the first consumer.
  if (made->mode_ == ChannelMode::one_to_many_pubsub) {
    made->watch_.stop();
    made->socket_.close();
  }
  return made;
}

UdpOutlet::UdpOutlet(ChannelHost& host, ChannelNumber number, Life life, const NamedPublication& publication)
    : PublisherChannel(host, number, life),
      mode_(publication.mode),
      binding_{publication.address, publication.port},
      silence_(host.reactor(), [this] {
        listeners_.expire(now());
        set_listener_timer();
      }) {
  const auto stated = peer_address(publication.address, publication.port);
  if (mode_ == ChannelMode::one_to_many_stream && stated && stated->is_multicast()) {
    group_ = stated;
    binding_ = {"", publication.port, true};
  }
}

std::expected<void, std::string> UdpOutlet::open_socket() {
  auto socket = open_datagrams(binding_);
  if (!socket) return std::unexpected(std::move(socket.error().text));
  socket_ = std::move(*socket);
  binding_.port = port_of(socket_);
  if (group_) group_->port = binding_.port;
  watch_ = host_.reactor().watch(socket_, [this](Reactor::Ready ready) {
    if (ready.can_write) is_full_ = false;
    if (ready.can_read) read();
    if (socket_.is_open()) watch_.want(true, is_full_);
  });
  return {};
}

bool UdpOutlet::has_consumer() const { return group_ || reachable_ > 0 || !listeners_.all().empty(); }

void UdpOutlet::transmit(const FrameHeader& header, std::span<const std::byte> payload) {
  const std::array plain{part(payload)};
  if (payload.size() > max_copied_payload) {
    const std::array framed{part(header), part(payload)};
    return send_to_all(framed, plain);
  }
  if (copied_.empty()) copied_.resize(header.size() + max_copied_payload);
  // std::ranges::copy of GCC 12 goes octet by octet here.
  std::memcpy(copied_.data(), header.data(), header.size());
  if (!payload.empty()) std::memcpy(copied_.data() + header.size(), payload.data(), payload.size());
  const std::array framed{part(std::span(copied_).first(header.size() + payload.size()))};
  send_to_all(framed, plain);
}

void UdpOutlet::send_to_all(std::span<const iovec> framed, std::span<const iovec> plain) {
  if (group_) {
    if (now() >= interfaces_until_) {
      interfaces_ = multicast_interfaces(group_->is_ipv4());
      if (group_->zone != 0) interfaces_ = {group_->zone};
      interfaces_until_ = now() + interfaces_interval;
    }
    for (const unsigned interface : interfaces_) send_to(*group_, framed, interface);
  }
  for (const auto& [number, consumer] : consumers_) {
    if (consumer.address.port == 0) continue;
    // A consumer without a life does not know frames.
    const auto for_it = counterparts_.at(number).life == no_life ? plain : framed;
    if (!for_it.empty()) send_to(consumer.address, for_it, 0);
  }
  for (const auto& listener : listeners_.all()) send_to(listener.address, framed, 0);
}

void UdpOutlet::send_to(const PeerAddress& to, std::span<const iovec> parts, unsigned interface) {
  const int error = send_datagram(socket_, to, parts, interface);
  if (error == 0) return;
  // A datagram that the system does not take is lost; the sequence shows it.
  ++count_.left_out;
  if (error == EAGAIN) {
    is_full_ = true;
    watch_.want(true, true);
  }
}

void UdpOutlet::on_consumer(Counterparts::Number) {
  reachable_ = static_cast<std::size_t>(
      std::ranges::count_if(consumers_, [](const auto& one) { return one.second.address.port != 0; }));
  if (reachable_ > 0 && !socket_.is_open() && !is_closed_) open_socket_of_first();
}

void UdpOutlet::open_socket_of_first() {
  const std::uint16_t stated = binding_.port;
  if (!open_socket()) {
    // Another socket has taken the port meanwhile.
    binding_.port = 0;
    if (const auto opened = open_socket(); !opened) {
      binding_.port = stated;
      return host_.tell(Problem{number_, "the channel cannot be opened: " + opened.error()});
    }
  }
  if (binding_.port != stated) host_.state_port(number_, binding_.port);
}

void UdpOutlet::on_consumer_gone(Counterparts::Number consumer, bool) {
  if (consumers_.at(consumer).address.port != 0 && reachable_ > 0) --reachable_;
  if (reachable_ > 0 || mode_ != ChannelMode::one_to_many_pubsub) return;
  watch_.stop();
  socket_.close();
  is_full_ = false;
}

void UdpOutlet::read() {
  const auto room = host_.datagram_room();
  for (int i = 0; i < datagrams_at_once && socket_.is_open(); ++i) {
    sockaddr_storage from{};
    socklen_t size = sizeof from;
    const auto count =
        ::recvfrom(socket_.get(), room.data(), room.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (count < 0) return;
    const auto frame = read_frame(room.first(static_cast<std::size_t>(count)));
    if (frame) {
      take(*frame, peer_address(from));
    } else {
      ++count_.dropped;
    }
  }
}

void UdpOutlet::take(const Frame& frame, const PeerAddress& from) {
  const bool is_ours = mode_ == ChannelMode::one_to_many_stream && !group_ && frame.life != no_life &&
                       frame.kind != FrameKind::message && payload_life(frame.payload) == life_;
  if (is_ours && frame.kind == FrameKind::end) {
    listeners_.end(from);
  } else if (!is_ours || !listeners_.hello(from, now())) {
    ++count_.dropped;
  }
  set_listener_timer();
}

void UdpOutlet::finish() {
  if (is_closed_) return;
  read();  // new listeners hear the end, too
  is_closed_ = true;
  const auto header = frame_header(FrameKind::end, life_, sequence_, 0);
  const std::array framed{part(header)};
  if (socket_.is_open()) send_to_all(framed, {});
  watch_.stop();
  socket_.close();
  silence_.set(base::never);
}

}  // namespace geminga::client
