// Sockets of channels, which never block.
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

/// Owns a descriptor and closes it. Moves and does not copy.
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
  /// AF_INET6 or AF_INET, of a socket that sends datagrams.
  [[nodiscard]] int family() const { return family_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  void close();

 private:
  int number_ = -1;
  int family_ = 0;
};

/// The reason why a socket could not be opened: the system's number and one line for a person.
struct SocketError {
  int number = 0;
  std::string text;
};

/// The address and port to which a socket is bound.
struct Binding {
  std::string address;     ///< numeric; empty: every address of the host, of both families where it has both
  std::uint16_t port = 0;  ///< 0: any
  bool is_shared = false;  ///< other sockets may be bound to the same, as for multicast
};

/// Opens a UDP socket.
[[nodiscard]] std::expected<Socket, SocketError> open_datagrams(const Binding& binding);
/// Opens a TCP socket that listens.
[[nodiscard]] std::expected<Socket, SocketError> open_listener(const Binding& binding);
/// Begins to connect a TCP socket, which becomes writable when that has succeeded or failed.
[[nodiscard]] std::expected<Socket, SocketError> open_connection(const PeerAddress& to);
/// Opens a UDP socket that receives this group and nothing else, on every interface that multicasts use.
[[nodiscard]] std::expected<Socket, SocketError> open_group(const PeerAddress& group);
/// Joins the group on interfaces that have come since. The system's error if it is joined on none, else 0.
int join_group(const Socket& socket, const PeerAddress& group);

/// The port that a socket is bound to.
[[nodiscard]] std::uint16_t port_of(const Socket& socket);
/// The address and port of the other end of a connection.
[[nodiscard]] PeerAddress peer_of(const Socket& socket);
/// The error of a connection, or 0.
[[nodiscard]] int pending_error(const Socket& socket);
/// Accepts one connection; nothing if none waits.
[[nodiscard]] std::optional<Socket> accept(const Socket& listener);

/// The interfaces that multicasts use: those that are up and have addresses of this family, or the loopback if there is
/// no other.
[[nodiscard]] std::vector<unsigned> multicast_interfaces(bool is_ipv4);

/// Octets as the system takes them for writing.
[[nodiscard]] inline iovec part(std::span<const std::byte> bytes) {
  return {const_cast<std::byte*>(bytes.data()), bytes.size()};
}

/// Writes to a connection. The number of octets that it took; nothing if it is broken.
[[nodiscard]] std::optional<std::size_t> write_some(const Socket& socket, std::span<iovec> parts);

/// Sends one datagram of these parts, through `interface` unless that is 0. The system's error number, or 0 if it is
/// sent.
[[nodiscard]] int send_datagram(const Socket& socket, const PeerAddress& to, std::span<const iovec> parts,
                                unsigned interface = 0);

}  // namespace geminga::client

#endif
