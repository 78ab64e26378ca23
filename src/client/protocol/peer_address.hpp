// Where a datagram or a connection comes from or goes to: an IP address with its port, in one form for both families.
#ifndef GEMINGA_CLIENT_PROTOCOL_PEER_ADDRESS_HPP
#define GEMINGA_CLIENT_PROTOCOL_PEER_ADDRESS_HPP

#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::client {

/// An IPv4 address has the form of an IPv4-mapped IPv6 one, so that both sockets name it alike.
struct PeerAddress {
  std::array<std::uint8_t, 16> octets{};
  std::uint32_t zone = 0;  ///< the number of the interface; of IPv6 link-local addresses only
  std::uint16_t port = 0;

  [[nodiscard]] bool is_ipv4() const;
  [[nodiscard]] bool is_multicast() const;
  friend auto operator<=>(const PeerAddress&, const PeerAddress&) = default;
};

/// The address of a numeric text, or nothing; also where its zone is no interface of this host.
[[nodiscard]] std::optional<PeerAddress> peer_address(std::string_view text, std::uint16_t port);
/// What the system says of a socket's other end.
[[nodiscard]] PeerAddress peer_address(const sockaddr_storage& from);

/// As the system wants it for a socket of this family: AF_INET6, where an IPv4 address is mapped, or AF_INET.
struct SystemAddress {
  sockaddr_storage storage{};
  socklen_t size = 0;
  [[nodiscard]] const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
};
/// Nothing for an IPv6 address and AF_INET.
[[nodiscard]] std::optional<SystemAddress> system_address(const PeerAddress& address, int family);

/// `10.0.0.2:5000`, for texts.
[[nodiscard]] std::string to_string(const PeerAddress& address);

}  // namespace geminga::client

#endif
