#include "client/channels/tcp_inlet.hpp"

#include <cerrno>
#include <utility>

namespace geminga::client {
namespace {

/// Reads of one connection before other sockets have their turn.
constexpr int reads_at_once = 16;

}  // namespace

TcpInlet::TcpInlet(ChannelHost& host, PeerAddress to, Sealer& sealer, Life provider, ChannelKeys keys, Told told)
    : host_(host),
      to_(to),
      sealer_(sealer),
      provider_(provider),
      told_(std::move(told)),
      intake_(std::move(keys)),
      retry_(host.reactor(), [this] { connect(); }),
      chance_(std::random_device()()),
      unconnected_since_(host.reactor().now()) {}

void TcpInlet::connect() {
  auto socket = open_connection(to_);
  if (!socket) return lose();
  socket_ = std::move(*socket);
  reader_ = FrameReader();
  handshake_.emplace(provider_, sealer_.life(), random_number());
  watch_ = host_.reactor().watch(socket_, [this](Reactor::Ready ready) { on_ready(ready); });
  watch_.want(false, true);
}

void TcpInlet::set_keys(ChannelKeys keys) {
  const FrameForm form = intake_.keys().form();
  intake_.set_keys(std::move(keys));
  if (!is_connected_ || intake_.keys().form() == form || handshake_->greeting().cookie == 0) return;
  // A connection that does not take it has ended, which is read from it soon.
  [[maybe_unused]] const bool was_said = say_hello();
}

void TcpInlet::pause(bool is_paused) {
  is_paused_ = is_paused;
  if (!is_connected_) return;
  watch_.want(!is_paused, false);
  // Frames that were read are in the reader, not in the socket.
  if (!is_paused) give();
}

bool TcpInlet::say_hello() {
  const auto hello = sealer_.frame(intake_.keys(), FrameKind::hello, 0, greeting_payload(handshake_->greeting()));
  // The buffer of a new connection has room for two hellos.
  return hello && host_.is_own_process() &&
         ::send(socket_.get(), hello->data(), hello->size(), MSG_NOSIGNAL) == static_cast<ssize_t>(hello->size());
}

void TcpInlet::on_ready(Reactor::Ready ready) {
  if (!is_connected_) {
    if (!ready.can_write) return;
    if (pending_error(socket_) != 0 || !say_hello()) return lose();
    is_connected_ = true;
    watch_.want(!is_paused_, false);
    return;
  }
  if (ready.can_read) read();
}

void TcpInlet::read() {
  for (int i = 0; i < reads_at_once && !is_paused_; ++i) {
    const auto room = reader_.room();
    const auto count = ::recv(socket_.get(), room.data(), room.size(), 0);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (count <= 0) return lose();
    reader_.fed(static_cast<std::size_t>(count));
    if (!give()) return;
    if (static_cast<std::size_t>(count) < room.size()) return;
  }
}

bool TcpInlet::give() {
  bool is_destroyed = false;
  is_destroyed_ = &is_destroyed;
  bool is_believed = true;
  while (!is_paused_ && is_believed) {
    const auto frame = reader_.next();
    if (!frame) break;
    is_believed = take(*frame);
    if (is_destroyed) return false;
  }
  is_destroyed_ = nullptr;
  if (reader_.is_broken() || !is_believed) {
    told_.dropped();
    lose();
    return false;
  }
  return !is_paused_;
}

bool TcpInlet::take(const ReadFrame& read) {
  const auto opened = intake_.open(read, opened_);
  if (!opened) return false;
  const Frame& frame = opened->frame;
  if (frame.life != provider_ || frame.kind == FrameKind::hello) {
    told_.dropped();
    return true;
  }
  if (frame.kind == FrameKind::floor) {
    return handshake_->on_floor(frame, opened->is_proved) != Handshake::Next::say_hello || say_hello();
  }
  if (frame.kind == FrameKind::full) {
    if (handshake_->on_full(frame) && !std::exchange(was_told_full_, true)) told_.full();
    return true;
  }
  // Nothing can be believed of a connection whose publisher seals and has said no floor: it is made again.
  if (opened->is_proved && !handshake_->floor()) return false;
  backoff_.reset();  // a peer that only accepts is not tried again at once
  was_told_full_ = false;
  if (opened->is_proved && frame.kind == FrameKind::message && frame.sequence <= *handshake_->floor()) return true;
  const bool* const destroyed = is_destroyed_;
  const bool goes_on = told_.frame(frame, opened->is_proved);
  if (*destroyed || goes_on) return true;
  is_paused_ = true;
  watch_.want(false, false);
  return true;
}

void TcpInlet::lose() {
  watch_.stop();
  socket_.close();
  if (std::exchange(is_connected_, false)) unconnected_since_ = host_.reactor().now();
  bool is_destroyed = false;
  is_destroyed_ = &is_destroyed;
  const bool is_wanted = told_.lost();
  if (is_destroyed) return;
  is_destroyed_ = nullptr;
  if (is_wanted) retry_.set(host_.reactor().now() + backoff_.next(chance_()));
}

}  // namespace geminga::client
