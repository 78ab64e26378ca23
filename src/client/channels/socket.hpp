// Sockets of channels: opened, owned, and never waited for.
#ifndef GEMINGA_CLIENT_CHANNELS_SOCKET_HPP
#define GEMINGA_CLIENT_CHANNELS_SOCKET_HPP

#include <sys/uio.h>

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client/protocol/peer_address.hpp"

namespace geminga::client {

/// Owns a descriptor and closes it at its end. Moves and does not copy.
class Socket {
 public:
  Socket() = default;
  explicit Socket(int number, int family = 0) : number_(number), family_(family) {}
  Socket(Socket&& other) noexcept : number_(std::exchange(other.number_, -1)), family_(other.family_) {}
  Socket& operator=(Socket&& other) noexcept {
    if (this != &other) {
      close();
      number_ = std::exchange(other.number_, -1);
      family_ = other.family_;
    }
    return *this;
  }
  ~Socket() { close(); }

  [[nodiscard]] int get() const { return number_; }
  /// AF_INET6 or AF_INET, of what sends datagrams.
  [[nodiscard]] int family() const { return family_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  void close();

 private:
  int number_ = -1;
  int family_ = 0;
};

/// Why a socket could not be opened: the system's number and one line for a person.
struct SocketError {
  int number = 0;
  std::string text;
};

/// What a socket is bound to.
struct Binding {
  std::string address;     ///< numeric; empty: every address of the host, of both families where it has both
  std::uint16_t port = 0;  ///< 0: any
  bool is_shared = false;  ///< others may be bound to the same, as for multicast
};

/// A UDP socket.
[[nodiscard]] std::expected<Socket, SocketError> open_datagrams(const Binding& binding);
/// A TCP socket that listens.
[[nodiscard]] std::expected<Socket, SocketError> open_listener(const Binding& binding);
/// A TCP socket that is on its way there: writable once it is decided.
[[nodiscard]] std::expected<Socket, SocketError> open_connection(const PeerAddress& to);
/// A UDP socket that hears this group and nothing else, from every interface that multicasts go through.
[[nodiscard]] std::expected<Socket, SocketError> open_group(const PeerAddress& group);
/// Joins it on those that have come since. The system's error where there is none at all, else 0.
int join_group(const Socket& socket, const PeerAddress& group);

/// The port that a socket is bound to.
[[nodiscard]] std::uint16_t port_of(const Socket& socket);
/// The error that a connection has met, or 0.
[[nodiscard]] int pending_error(const Socket& socket);
/// Accepts one connection; nothing where none waits.
[[nodiscard]] std::optional<Socket> accept(const Socket& listener);

/// The interfaces that a multicast leaves by: those that are up and have addresses of this family, and the loopback
/// where there is no other.
[[nodiscard]] std::vector<unsigned> multicast_interfaces(bool is_ipv4);

/// Octets that are only read, as the system wants them.
[[nodiscard]] inline iovec part(std::span<const std::byte> bytes) {
  return {const_cast<std::byte*>(bytes.data()), bytes.size()};
}

/// Sends one datagram of these parts; from `interface` where it is not 0. Gives the system's error number, 0 where it
/// is sent.
[[nodiscard]] int send_datagram(const Socket& socket, const PeerAddress& to, std::span<const iovec> parts,
                                unsigned interface = 0);

}  // namespace geminga::client

#endif
