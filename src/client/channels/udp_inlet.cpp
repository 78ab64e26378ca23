#include "client/channels/udp_inlet.hpp"

#include <array>
#include <utility>

#include "client/protocol/limits.hpp"

namespace geminga::client {
namespace {

/// Datagrams of one socket before other sockets have their turn.
constexpr int datagrams_a_turn = 256;
/// Datagrams that are read at the end of a provider: more than the buffer of a socket holds.
constexpr int datagrams_at_end = 16'384;

}  // namespace

UdpInlet::UdpInlet(ChannelHost& host, Life own, Told told)
    : host_(host),
      own_(own),
      told_(std::move(told)),
      hello_(host.reactor(), [this] { say_hello_to_all(); }),
      interfaces_(host.reactor(), [this] { join_all(); }) {}

UdpInlet::~UdpInlet() {
  for (const auto& [number, source] : sources_) {
    if (source.says_hello) say(source, FrameKind::end);
  }
}

std::expected<std::uint16_t, std::string> UdpInlet::open(const std::string& address, std::uint16_t port) {
  auto socket = open_datagrams({address, port});
  if (!socket) return std::unexpected(std::move(socket.error().text));
  socket_ = std::move(*socket);
  watch_ = host_.reactor().watch(socket_, [this](Reactor::Ready) { read(socket_, std::nullopt, datagrams_a_turn); });
  return port_of(socket_);
}

void UdpInlet::hear(Number provider, Life life, const PeerAddress& address, bool says_hello) {
  sources_[provider] = {life, address, says_hello};
  by_address_[address] = provider;
  if (says_hello) say_hello_to_all();
}

void UdpInlet::join(Number provider, Life life, const PeerAddress& address) {
  auto group = open_group(address);
  if (!group) return told_.problem("the group " + to_string(address) + " cannot be joined: " + group.error().text);
  Source& source = sources_[provider];
  source = {life, address, false, std::move(*group)};
  source.group_watch = host_.reactor().watch(source.group, [this, provider](Reactor::Ready) {
    if (const auto found = sources_.find(provider); found != sources_.end()) {
      read(found->second.group, provider, datagrams_a_turn);
    }
  });
  interfaces_.set(now() + interfaces_interval);
}

void UdpInlet::forget(Number provider) {
  const auto found = sources_.find(provider);
  if (found == sources_.end()) return;
  Source& source = found->second;
  if (source.says_hello) say(source, FrameKind::end);
  const auto address = by_address_.find(source.address);
  if (address != by_address_.end() && address->second == provider) by_address_.erase(address);
  source.group_watch.stop();
  sources_.erase(found);
}

void UdpInlet::deliver_early(Number provider) {
  const auto source = sources_.find(provider);
  if (source == sources_.end() || source->second.group.is_open()) return;
  for (const auto& kept : early_.take(source->second.address, source->second.life, now())) {
    told_.found();
    told_.frame(provider, kept.frame());
    if (!sources_.contains(provider)) return;  // it has ended already
  }
}

void UdpInlet::read_all(Number provider) {
  const auto source = sources_.find(provider);
  if (source == sources_.end()) return;
  if (source->second.group.is_open()) {
    read(source->second.group, provider, datagrams_at_end);
  } else {
    read(socket_, std::nullopt, datagrams_at_end);
  }
}

void UdpInlet::read(const Socket& socket, std::optional<Number> group, int most) {
  const auto room = host_.datagram_room();
  for (int i = 0; i < most && socket.is_open(); ++i) {
    sockaddr_storage from{};
    socklen_t size = sizeof from;
    const auto count = ::recvfrom(socket.get(), room.data(), room.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (count < 0) return;
    take(room.first(static_cast<std::size_t>(count)), peer_address(from), group);
    if (group && !sources_.contains(*group)) return;  // and the socket with it
  }
}

void UdpInlet::take(std::span<const std::byte> bytes, const PeerAddress& from, std::optional<Number> group) {
  std::optional<Number> number;
  if (group) {
    if (from.port == sources_.at(*group).address.port) number = group;
  } else if (const auto found = by_address_.find(from); found != by_address_.end()) {
    number = found->second;
  }
  if (number && sources_.at(*number).life == no_life) return told_.plain(*number, bytes);
  const auto frame = read_frame(bytes);
  if (frame && number && (group || frame->life == sources_.at(*number).life)) return told_.frame(*number, *frame);
  told_.dropped();
  if (frame && !group && frame->kind != FrameKind::hello) early_.put(from, *frame, now());
}

void UdpInlet::say_hello_to_all() {
  bool has_stream = false;
  for (const auto& [number, source] : sources_) {
    if (!source.says_hello) continue;
    has_stream = true;
    say(source, FrameKind::hello);
  }
  hello_.set(has_stream ? now() + hello_interval : base::never);
}

void UdpInlet::say(const Source& source, FrameKind kind) const {
  if (!socket_.is_open()) return;
  const auto payload = life_payload(source.life);
  const auto bytes = frame_bytes({kind, own_, 0, payload});
  const std::array parts{part(bytes)};
  // A hello that is lost is followed by the next one.
  [[maybe_unused]] const int error = send_datagram(socket_, source.address, parts);
}

void UdpInlet::join_all() {
  bool has_group = false;
  for (const auto& [number, source] : sources_) {
    if (!source.group.is_open()) continue;
    has_group = true;
    join_group(source.group, source.address);
  }
  interfaces_.set(has_group ? now() + interfaces_interval : base::never);
}

}  // namespace geminga::client
