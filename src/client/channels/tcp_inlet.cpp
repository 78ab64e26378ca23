#include "client/channels/tcp_inlet.hpp"

#include <cerrno>
#include <utility>

namespace geminga::client {
namespace {

/// Reads of one connection before other sockets have their turn.
constexpr int reads_at_once = 16;

}  // namespace

TcpInlet::TcpInlet(Reactor& reactor, PeerAddress to, Life own, Told told)
    : reactor_(reactor),
      to_(to),
      own_(own),
      told_(std::move(told)),
      retry_(reactor, [this] { connect(); }),
      chance_(std::random_device()()) {}

void TcpInlet::connect() {
  auto socket = open_connection(to_);
  if (!socket) return lose();
  socket_ = std::move(*socket);
  reader_ = FrameReader();
  watch_ = reactor_.watch(socket_, [this](Reactor::Ready ready) { on_ready(ready); });
  watch_.want(false, true);
}

void TcpInlet::pause(bool is_paused) {
  is_paused_ = is_paused;
  if (!is_connected_) return;
  watch_.want(!is_paused, false);
  // Frames that were read are in the reader, not in the socket.
  if (!is_paused) give();
}

void TcpInlet::on_ready(Reactor::Ready ready) {
  if (!is_connected_) {
    if (!ready.can_write) return;
    if (pending_error(socket_) != 0) return lose();
    const auto hello = frame_bytes({FrameKind::hello, own_, 0, {}});
    // The buffer of a new connection has room for a hello.
    if (::send(socket_.get(), hello.data(), hello.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(hello.size())) {
      return lose();
    }
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
  while (!is_paused_) {
    const auto frame = reader_.next();
    if (!frame) break;
    backoff_.reset();  // a peer that only accepts is not tried again at once
    const bool goes_on = told_.frame(*frame);
    if (is_destroyed) return false;
    if (!goes_on) {
      is_paused_ = true;
      watch_.want(false, false);
    }
  }
  is_destroyed_ = nullptr;
  if (reader_.is_broken()) {
    told_.broken();
    lose();
    return false;
  }
  return !is_paused_;
}

void TcpInlet::lose() {
  watch_.stop();
  socket_.close();
  is_connected_ = false;
  bool is_destroyed = false;
  is_destroyed_ = &is_destroyed;
  const bool is_wanted = told_.lost();
  if (is_destroyed) return;
  is_destroyed_ = nullptr;
  if (is_wanted) retry_.set(reactor_.now() + backoff_.next(chance_()));
}

}  // namespace geminga::client
