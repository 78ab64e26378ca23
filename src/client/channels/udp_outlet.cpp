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
        tell_crowding(crowding_.on_left(listeners_.places()), listeners_.places(), "listeners");
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
    if (ready.can_read) read(socket_);
    if (socket_.is_open()) watch_.want(true, is_full_);
  });
  return {};
}

bool UdpOutlet::has_consumer() const { return group_ || reachable_ > 0 || !listeners_.all().empty(); }

bool UdpOutlet::is_sent_to(Counterparts::Number number, const Consumer& consumer) const {
  if (consumer.address.port == 0) return false;
  if (counterparts_.at(number).life == no_life) return !lacks_life(number);
  return !seals() || consumer.has_greeted;
}

bool UdpOutlet::is_reached(Counterparts::Number consumer) const {
  const Consumer& one = consumers_.at(consumer);
  return keys_ && (one.address.port == 0 || is_sent_to(consumer, one));
}

void UdpOutlet::count_reachable() {
  addressed_ = 0;
  reachable_ = 0;
  for (const auto& [number, consumer] : consumers_) {
    if (consumer.address.port != 0) ++addressed_;
    if (is_sent_to(number, consumer)) ++reachable_;
  }
}

void UdpOutlet::on_keys(bool seals_newly) {
  count_reachable();
  if (group_ && seals() && !hello_socket_.is_open()) open_hello_socket();
  if (!seals_newly) return;
  // Those that were heard without a key get a floor that they can believe, behind which nothing is lost.
  for (const auto& [address, listener] : listeners_.all()) {
    say(FrameKind::floor, address, {listener.life, listener.challenge, 0});
  }
  for (const auto& [number, consumer] : consumers_) {
    const Life life = counterparts_.at(number).life;
    if (consumer.has_greeted) say(FrameKind::floor, consumer.address, {life, consumer.challenge, 0});
  }
}

void UdpOutlet::open_hello_socket() {
  auto socket = open_datagrams({"", 0});
  if (!socket) return problem("no hellos can be heard: " + socket.error().text);
  hello_socket_ = std::move(*socket);
  hello_port_ = port_of(hello_socket_);
  hello_watch_ = host_.reactor().watch(hello_socket_, [this](Reactor::Ready) { read(hello_socket_); });
}

void UdpOutlet::transmit(std::span<const std::byte> payload) {
  if (seals()) return transmit_sealed(payload);
  const auto header = frame_header(FrameKind::message, life_, sequence_, payload.size());
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

void UdpOutlet::transmit_sealed(std::span<const std::byte> payload) {
  const std::size_t size = sealed_size(payload.size());
  if (copied_.size() < size) copied_.resize(size);
  if (!sealer_.seal(*keys_, FrameKind::message, sequence_, payload, hello_port_, copied_.data())) return finish();
  const std::array framed{part(std::span(copied_).first(size))};
  const std::array plain{part(payload)};
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
    if (!is_sent_to(number, consumer)) continue;
    // A consumer without a life does not know frames.
    const auto for_it = counterparts_.at(number).life == no_life ? plain : framed;
    if (!for_it.empty()) send_to(consumer.address, for_it, 0);
  }
  for (const auto& [address, listener] : listeners_.all()) send_to(address, framed, 0);
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
  count_reachable();
  if (addressed_ > 0 && !socket_.is_open() && !is_closed_) open_socket_of_first();
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
  Consumer& gone = consumers_.at(consumer);
  gone.address = {};  // the channel forgets it behind this call
  gone.has_greeted = false;
  count_reachable();
  if (addressed_ > 0 || mode_ != ChannelMode::one_to_many_pubsub) return;
  watch_.stop();
  socket_.close();
  is_full_ = false;
}

void UdpOutlet::read(const Socket& socket) {
  const auto room = host_.datagram_room();
  for (int i = 0; i < datagrams_at_once && socket.is_open(); ++i) {
    sockaddr_storage from{};
    socklen_t size = sizeof from;
    const auto count = ::recvfrom(socket.get(), room.data(), room.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (count < 0) return;
    if (!take(room.first(static_cast<std::size_t>(count)), peer_address(from))) ++count_.dropped;
  }
}

bool UdpOutlet::take(std::span<const std::byte> datagram, const PeerAddress& from) {
  const auto read = read_frame(datagram);
  if (!read || !keys_) return false;
  Word word{*read, {}, {}, from};
  if (read->form == FrameForm::plain) {
    if (!takes_plain()) return false;
  } else {
    const auto opened = open_frame(*read, *keys_, Direction::back, opened_);
    if (!opened) return false;
    word.frame = *opened;
    word.counter = seal_fields(*read).counter;
  }
  const auto greeting = read_greeting(word.frame.payload);
  if (!greeting || greeting->life != life_ || greeting->challenge == 0) return false;
  word.greeting = *greeting;
  if (word.frame.kind == FrameKind::end) return take_end(word);
  return word.frame.kind == FrameKind::hello && take_hello(word);
}

bool UdpOutlet::take_end(const Word& word) {
  const auto* listener = listeners_.find(word.from);
  if (listener == nullptr) return mode_ == ChannelMode::one_to_many_stream;
  if (word.counter && (listener->life != word.frame.life || *word.counter <= listener->counter)) return false;
  listeners_.end(word.from);
  tell_crowding(crowding_.on_left(listeners_.places()), listeners_.places(), "listeners");
  return true;
}

bool UdpOutlet::take_hello(const Word& word) {
  const Life life = word.frame.life;
  const Greeting accepted{life, word.greeting.challenge, 0};
  if (group_) {
    answer(FrameKind::floor, word.from, accepted);
    return true;
  }
  if (mode_ != ChannelMode::one_to_many_stream && !keys_->has_ring()) return false;
  if (mode_ == ChannelMode::one_to_many_stream) {
    auto* known = listeners_.find(word.from);
    // One that has said plain hellos has to show a cookie when it seals them.
    if (known != nullptr && (!word.counter || (known->life == life && known->counter != 0))) {
      if (word.counter && *word.counter <= known->counter) return false;
      known->until = now() + listener_patience;
      if (known->life != life) known->counter = 0;
      known->life = life;
      known->challenge = word.greeting.challenge;
      known->counter = word.counter.value_or(known->counter);
      renew(word.from, accepted);
      return true;
    }
  } else if (const auto counterpart = counterparts_.find(life); counterpart && renews(*counterpart, word)) {
    Consumer& known = consumers_.at(*counterpart);
    if (word.counter && *word.counter <= known.counter) return false;
    known.challenge = word.greeting.challenge;
    known.counter = word.counter.value_or(known.counter);
    renew(word.from, accepted);
    return true;
  }
  if (cookies_.accepts(word.greeting.cookie, word.from, life, word.greeting.challenge, now())) return accept(word);
  answer(FrameKind::floor, word.from,
         {life, word.greeting.challenge, cookies_.make(word.from, life, word.greeting.challenge, now())});
  return true;
}

bool UdpOutlet::renews(Counterparts::Number number, const Word& word) const {
  const Consumer& known = consumers_.at(number);
  return known.has_greeted && (!word.counter || known.counter != 0);
}

bool UdpOutlet::accept(const Word& word) {
  const Life life = word.frame.life;
  if (mode_ != ChannelMode::one_to_many_stream) {
    // A consumer of which the daemon has not told yet says hello again, and gets no answer until then: an answer with
    // a cookie would be followed by a hello at once, and so on.
    const auto counterpart = counterparts_.find(life);
    if (!counterpart) return true;
    Consumer& consumer = consumers_.at(*counterpart);
    consumer.has_greeted = true;
    consumer.challenge = word.greeting.challenge;
    consumer.counter = word.counter.value_or(0);
    count_reachable();
    answer(FrameKind::floor, word.from, {life, word.greeting.challenge, 0});
    appear(*counterpart);
    return true;
  }
  const auto added = listeners_.add({word.from, life, word.greeting.challenge, word.counter.value_or(0)}, now());
  if (added.loser) say(FrameKind::full, added.loser->address, {added.loser->life, added.loser->challenge, 0});
  if (!added.is_added || added.loser) {
    tell_crowding(crowding_.on_full(), listeners_.places(), "listeners");
  }
  answer(added.is_added ? FrameKind::floor : FrameKind::full, word.from, {life, word.greeting.challenge, 0});
  set_listener_timer();
  return true;
}

void UdpOutlet::answer(FrameKind kind, const PeerAddress& to, const Greeting& greeting) {
  if (answers_.take(now())) say(kind, to, greeting);
}

void UdpOutlet::renew(const PeerAddress& to, const Greeting& greeting) {
  if (answers_.take_renewal(now())) say(FrameKind::floor, to, greeting);
}

void UdpOutlet::say(FrameKind kind, const PeerAddress& to, const Greeting& greeting) {
  const Socket& from = group_ ? hello_socket_ : socket_;
  if (!from.is_open() || !host_.is_own_process()) return;
  const auto octets = sealer_.frame(*keys_, kind, sequence_, greeting_payload(greeting));
  if (!octets) return;
  const std::array parts{part(*octets)};
  // An answer that is lost is asked for again.
  [[maybe_unused]] const int error = send_datagram(from, to, parts);
}

void UdpOutlet::set_listener_timer() {
  // Listeners are renewed far more often than they end: the timer looks again when the first one might have ended.
  if (silence_.at() == base::never) silence_.set(listeners_.next_end());
}

void UdpOutlet::finish() {
  if (is_closed_) return;
  read(socket_);  // new listeners hear the end, too
  is_closed_ = true;
  if (socket_.is_open() && keys_ && host_.is_own_process()) {
    const auto end = sealer_.frame(*keys_, FrameKind::end, sequence_, {}, hello_port_);
    if (end) {
      const std::array framed{part(*end)};
      send_to_all(framed, {});
    }
  }
  watch_.stop();
  socket_.close();
  hello_watch_.stop();
  hello_socket_.close();
  silence_.set(base::never);
}

}  // namespace geminga::client
