#include "client/channels/udp_inlet.hpp"

#include <algorithm>
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

UdpInlet::UdpInlet(ChannelHost& host, Sealer& sealer, Told told)
    : host_(host),
      sealer_(sealer),
      told_(std::move(told)),
      hello_(host.reactor(), [this] { say_due_hellos(); }),
      interfaces_(host.reactor(), [this] { join_all(); }) {}

UdpInlet::~UdpInlet() {
  for (const auto& [number, source] : sources_) {
    if (source.is_stream) say(source, FrameKind::end);
  }
}

std::expected<std::uint16_t, std::string> UdpInlet::open(const std::string& address, std::uint16_t port) {
  auto socket = open_datagrams({address, port});
  if (!socket) return std::unexpected(std::move(socket.error().text));
  socket_ = std::move(*socket);
  watch_ = host_.reactor().watch(socket_, [this](Reactor::Ready) { read(socket_, std::nullopt, datagrams_a_turn); });
  return port_of(socket_);
}

void UdpInlet::hear(Number provider, Life life, const PeerAddress& address, const ChannelKeys& keys, bool is_stream) {
  Source& source = sources_.insert_or_assign(provider, Source{life, address, Intake(keys), is_stream}).first->second;
  by_address_[address] = provider;
  source.greeted = address;
  begin_handshake(source);
}

void UdpInlet::join(Number provider, Life life, const PeerAddress& address, const ChannelKeys& keys) {
  auto group = open_group(address);
  if (!group) return told_.problem("the group " + to_string(address) + " cannot be joined: " + group.error().text);
  Source& source = sources_.insert_or_assign(provider, Source{life, address, Intake(keys)}).first->second;
  source.group = std::move(*group);
  source.group_watch = host_.reactor().watch(source.group, [this, provider](Reactor::Ready) {
    if (const auto found = sources_.find(provider); found != sources_.end()) {
      read(found->second.group, provider, datagrams_a_turn);
    }
  });
  interfaces_.set(now() + interfaces_interval);
}

void UdpInlet::set_keys(Number provider, const ChannelKeys& keys) {
  const auto found = sources_.find(provider);
  if (found == sources_.end()) return;
  Source& source = found->second;
  const FrameForm form = source.intake.keys().form();
  source.intake.set_keys(keys);
  if (source.group.is_open()) return;
  begin_handshake(source);
  // The publisher learns at once that hellos are sealed.
  if (!source.handshake || source.intake.keys().form() == form) return;
  say_hello(source);
  set_timer();
}

void UdpInlet::begin_handshake(Source& source) {
  const bool is_wanted = source.life != no_life && (source.is_stream || source.intake.keys().has_ring());
  if (is_wanted == source.handshake.has_value()) return;
  source.handshake.reset();
  source.due = base::never;
  if (is_wanted) {
    source.handshake.emplace(source.life, sealer_.life(), random_number());
    say_hello(source);
  }
  set_timer();
}

void UdpInlet::greet(Number number, const PeerAddress& at) {
  Source& source = sources_.at(number);
  if ((source.greeted == at && source.handshake) || (by_address_.contains(at) && by_address_.at(at) != number)) return;
  if (source.greeted) by_address_.erase(*source.greeted);
  source.greeted = at;
  by_address_[at] = number;
  if (!source.handshake) source.handshake.emplace(source.life, sealer_.life(), random_number());
  say_hello(source);
  set_timer();
}

void UdpInlet::forget(Number provider) {
  const auto found = sources_.find(provider);
  if (found == sources_.end()) return;
  Source& source = found->second;
  if (source.is_stream) say(source, FrameKind::end);
  if (source.greeted) {
    const auto address = by_address_.find(*source.greeted);
    if (address != by_address_.end() && address->second == provider) by_address_.erase(address);
  }
  source.group_watch.stop();
  sources_.erase(found);
}

void UdpInlet::deliver_early(Number provider) {
  const auto source = sources_.find(provider);
  if (source == sources_.end()) return;
  for (const auto& kept : early_.take(source->second.address, source->second.life, now())) {
    told_.found();
    if (!take_frame(provider, kept.frame(), kept.from)) told_.dropped();
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

std::optional<UdpInlet::Number> UdpInlet::source_of(const PeerAddress& from, std::optional<Number> group) const {
  if (group) return from.port == sources_.at(*group).address.port ? group : std::nullopt;
  const auto found = by_address_.find(from);
  return found == by_address_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<UdpInlet::Number> UdpInlet::answerer_of(const ReadFrame& frame) const {
  if (frame.form == FrameForm::plain || (frame.kind != FrameKind::floor && frame.kind != FrameKind::full))
    return std::nullopt;
  const auto found = std::ranges::find_if(
      sources_, [&](const auto& one) { return one.second.life == frame.life && one.second.handshake; });
  return found == sources_.end() ? std::nullopt : std::optional(found->first);
}

void UdpInlet::take(std::span<const std::byte> bytes, const PeerAddress& from, std::optional<Number> group) {
  auto number = source_of(from, group);
  if (number && sources_.at(*number).life == no_life) return told_.plain(*number, bytes);
  const auto frame = read_frame(bytes);
  if (!number && !group && frame) number = answerer_of(*frame);
  if (frame && number && frame->life == sources_.at(*number).life) {
    // Answers to a hello come to the own socket, messages of a group to the group.
    const bool is_answer = frame->kind == FrameKind::floor || frame->kind == FrameKind::full;
    const bool is_place = !sources_.at(*number).group.is_open() || group.has_value() != is_answer;
    if (!is_place || !take_frame(*number, *frame, from)) told_.dropped();
    return;
  }
  told_.dropped();
  if (frame && !group && (frame->kind == FrameKind::message || frame->kind == FrameKind::end)) {
    early_.put(from, *frame, now());
  }
}

bool UdpInlet::take_frame(Number number, const ReadFrame& read, const PeerAddress& from) {
  Source& source = sources_.at(number);
  const auto opened = source.intake.open(read, opened_);
  if (!opened) return false;
  switch (read.kind) {
    case FrameKind::floor:
      on_floor(number, opened->frame, opened->is_proved);
      return true;
    case FrameKind::full:
      if (source.handshake && source.handshake->on_full(opened->frame)) {
        told_.problem("the provider " + to_string(source.address) + " has no place for another consumer");
      }
      return true;
    case FrameKind::hello:
      return false;
    case FrameKind::message:
    case FrameKind::end:
      break;
  }
  if (!opened->is_proved) {
    told_.frame(number, opened->frame, false);
    return true;
  }
  if (!source.handshake || !source.handshake->floor()) return await_floor(number, read, from);
  if (read.kind == FrameKind::message && read.sequence <= *source.handshake->floor()) return true;
  told_.frame(number, opened->frame, true);
  return true;
}

bool UdpInlet::await_floor(Number number, const ReadFrame& frame, const PeerAddress& from) {
  Source& source = sources_.at(number);
  early_.put(source.address, frame, now());
  if (source.group.is_open()) {
    // A host without a route for multicasts sends them from 0.0.0.0, through its loopback.
    PeerAddress at = from == *peer_address("0.0.0.0", from.port) ? *peer_address("127.0.0.1", 0) : from;
    at.port = seal_fields(frame).hello_port;
    if (at.port != 0) greet(number, at);
  }
  return false;  // until it is delivered
}

void UdpInlet::on_floor(Number number, const Frame& frame, bool is_proved) {
  Source& source = sources_.at(number);
  if (!source.handshake) return;
  const bool had_floor = source.handshake->floor().has_value();
  const auto next = source.handshake->on_floor(frame, is_proved);
  if (next == Handshake::Next::say_hello) {
    say_hello(source);
    set_timer();
  } else if (next == Handshake::Next::go_on && source.group.is_open()) {
    source.due = base::never;
  }
  if (!had_floor && source.handshake->floor()) deliver_early(number);
}

void UdpInlet::say_due_hellos() {
  for (auto& [number, source] : sources_) {
    if (source.due <= now()) say_hello(source);
  }
  set_timer();
}

void UdpInlet::say_hello(Source& source) {
  say(source, FrameKind::hello);
  source.due = source.handshake->said(now());
}

void UdpInlet::set_timer() {
  base::Instant next = base::never;
  for (const auto& [number, source] : sources_) next = std::min(next, source.due);
  hello_.set(next);
}

void UdpInlet::say(const Source& source, FrameKind kind) {
  if (!socket_.is_open() || !source.handshake || !host_.is_own_process()) return;
  const auto bytes = sealer_.frame(source.intake.keys(), kind, 0, greeting_payload(source.handshake->greeting()));
  if (!bytes) return;
  const std::array parts{part(*bytes)};
  // A hello that is lost is followed by the next one.
  [[maybe_unused]] const int error = send_datagram(socket_, *source.greeted, parts);
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
