#include "bridge/words/daemon_socket.hpp"

#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "client/protocol/peer_address.hpp"
#include "discovery/keeping/frame.hpp"

namespace geminga::bridge {
namespace {

/// Datagrams that are read before other work has its turn.
constexpr int words_at_once = 64;

}  // namespace

std::expected<std::unique_ptr<DaemonSocket>, std::string> DaemonSocket::open(const client::Endpoint& own,
                                                                             const client::Endpoint& daemon,
                                                                             client::Reactor& reactor, Tally& tally,
                                                                             Told told) {
  auto socket = client::open_datagrams({.address = own.address, .port = own.port});
  if (!socket) return std::unexpected(client::to_string(own) + ": " + socket.error().text);
  const auto peer = client::peer_address(daemon.address, daemon.port);
  const auto place = peer ? client::system_address(*peer, socket->family()) : std::nullopt;
  if (!place) return std::unexpected(client::to_string(daemon) + " cannot be reached from " + client::to_string(own));
  if (::connect(socket->get(), place->get(), place->size) != 0) {
    return std::unexpected(client::to_string(daemon) + ": " + std::strerror(errno));
  }
  return std::unique_ptr<DaemonSocket>(new DaemonSocket(std::move(*socket), reactor, tally, std::move(told)));
}

DaemonSocket::DaemonSocket(client::Socket socket, client::Reactor& reactor, Tally& tally, Told told)
    : socket_(std::move(socket)),
      reactor_(reactor),
      tally_(tally),
      told_(std::move(told)),
      out_(words_per_second),
      in_(words_per_second),
      watch_(reactor.watch(socket_, [this](client::Reactor::Ready) { read(); })) {}

void DaemonSocket::read() {
  for (int i = 0; i < words_at_once; ++i) {
    const ssize_t size = ::recv(socket_.get(), room_.data(), room_.size(), MSG_DONTWAIT);
    if (size < 0) return;  // nothing more; or the daemon is away, which the next datagram tells
    if (size == 0) continue;
    const auto octets = static_cast<std::size_t>(size);
    if (keeping::is_frame(Word(room_.data(), octets))) {
      if (told_.frame) told_.frame(Word(room_.data(), octets));
    } else if (octets > max_word_bytes) {
      tally_.count("words of the daemon that are too long");
    } else if (!out_.take(reactor_.now())) {
      tally_.count("words of the daemon over the limit of a second");
    } else {
      look_at_session(Word(room_.data(), octets));
      told_.word(Word(room_.data(), octets));
    }
  }
}

/// A sealed datagram says its session in the clear, in its octets 4 to 11 (SEALING.md, "The datagram").
void DaemonSocket::look_at_session(Word word) {
  if (word.size() < 12 || word[0] != std::byte{'G'}) return;
  std::uint64_t session = 0;
  std::memcpy(&session, word.data() + 4, sizeof session);
  if (std::exchange(session_, session) != session && told_.began) told_.began();
}

void DaemonSocket::tell(Word frame) {
  [[maybe_unused]] const auto sent = ::send(socket_.get(), frame.data(), frame.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
}

DaemonSocket::Given DaemonSocket::give(Word word) {
  if (word.empty() || word.size() > max_word_bytes) return Given::too_long;
  {
    const std::lock_guard lock(mutex_);
    if (!in_.take(reactor_.now())) return Given::too_many;
  }
  // A daemon that is away, or too busy, misses it, as it would on the air.
  [[maybe_unused]] const auto sent = ::send(socket_.get(), word.data(), word.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  return Given::given;
}

}  // namespace geminga::bridge
