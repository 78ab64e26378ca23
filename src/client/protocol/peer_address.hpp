// The IP address and port of a peer, in one form for both families.
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

/// An IPv4 address is kept as an IPv4-mapped IPv6 address, so that the sockets of both families name it alike.
struct PeerAddress {
  std::array<std::uint8_t, 16> octets{};
  std::uint32_t zone = 0;  ///< the number of the interface, of IPv6 link-local addresses only
  std::uint16_t port = 0;

  [[nodiscard]] bool is_ipv4() const;
  [[nodiscard]] bool is_multicast() const;
  friend auto operator<=>(const PeerAddress&, const PeerAddress&) = default;
};

/// The address of a numeric text; nothing if it is none, or its zone is no interface of this host.
[[nodiscard]] std::optional<PeerAddress> peer_address(std::string_view text, std::uint16_t port);
/// The address that the system gives for a socket's other end.
[[nodiscard]] PeerAddress peer_address(const sockaddr_storage& from);

/// An address as the system takes it for a socket of AF_INET6, where an IPv4 address is mapped, or of AF_INET.
struct SystemAddress {
  sockaddr_storage storage{};
  socklen_t size = 0;
  [[nodiscard]] const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
};
/// The address for a socket of this family. Nothing for an IPv6 address and AF_INET.
[[nodiscard]] std::optional<SystemAddress> system_address(const PeerAddress& address, int family);

/// `10.0.0.2:5000`, for texts.
[[nodiscard]] std::string to_string(const PeerAddress& address);

}  // namespace geminga::client

#endif
