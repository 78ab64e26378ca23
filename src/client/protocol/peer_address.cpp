#include "client/protocol/peer_address.hpp"

#include <net/if.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/address.hpp"

namespace geminga::client {
namespace {

constexpr std::array<std::uint8_t, 12> mapped{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};

bool is_link_local(const std::array<std::uint8_t, 16>& octets) {
  return (octets[0] == 0xfe && (octets[1] & 0xc0) == 0x80) || (octets[0] == 0xff && (octets[1] & 0x0f) == 2);
}

}  // namespace

bool PeerAddress::is_ipv4() const { return std::equal(mapped.begin(), mapped.end(), octets.begin()); }

bool PeerAddress::is_multicast() const { return is_ipv4() ? (octets[12] & 0xf0) == 0xe0 : octets[0] == 0xff; }

std::optional<PeerAddress> peer_address(std::string_view text, std::uint16_t port) {
  const auto address = base::parse_address(text);
  if (!address) return std::nullopt;
  PeerAddress peer;
  peer.port = port;
  if (address->is_ipv6()) {
    std::ranges::copy(address->octets, peer.octets.begin());
    if (!address->zone.empty()) {
      peer.zone = ::if_nametoindex(address->zone.c_str());
      if (peer.zone == 0) return std::nullopt;
    }
  } else {
    std::ranges::copy(mapped, peer.octets.begin());
    std::ranges::copy(address->octets, peer.octets.begin() + mapped.size());
  }
  return peer;
}

PeerAddress peer_address(const sockaddr_storage& from) {
  PeerAddress peer;
  if (from.ss_family == AF_INET) {
    sockaddr_in four{};
    std::memcpy(&four, &from, sizeof four);
    std::ranges::copy(mapped, peer.octets.begin());
    std::memcpy(peer.octets.data() + mapped.size(), &four.sin_addr, sizeof four.sin_addr);
    peer.port = ntohs(four.sin_port);
  } else if (from.ss_family == AF_INET6) {
    sockaddr_in6 six{};
    std::memcpy(&six, &from, sizeof six);
    std::memcpy(peer.octets.data(), &six.sin6_addr, sizeof six.sin6_addr);
    if (is_link_local(peer.octets)) peer.zone = six.sin6_scope_id;
    peer.port = ntohs(six.sin6_port);
  }
  return peer;
}

std::optional<SystemAddress> system_address(const PeerAddress& address, int family) {
  SystemAddress system;
  if (family == AF_INET) {
    if (!address.is_ipv4()) return std::nullopt;
    sockaddr_in four{};
    four.sin_family = AF_INET;
    four.sin_port = htons(address.port);
    std::memcpy(&four.sin_addr, address.octets.data() + mapped.size(), sizeof four.sin_addr);
    std::memcpy(&system.storage, &four, sizeof four);
    system.size = sizeof four;
    return system;
  }
  sockaddr_in6 six{};
  six.sin6_family = AF_INET6;
  six.sin6_port = htons(address.port);
  six.sin6_scope_id = address.zone;
  std::memcpy(&six.sin6_addr, address.octets.data(), sizeof six.sin6_addr);
  std::memcpy(&system.storage, &six, sizeof six);
  system.size = sizeof six;
  return system;
}

std::string to_string(const PeerAddress& address) {
  base::Address text;
  const auto begin = address.octets.begin() + (address.is_ipv4() ? static_cast<std::ptrdiff_t>(mapped.size()) : 0);
  text.octets.assign(begin, address.octets.end());
  const std::string shown = text.text();
  return (text.is_ipv6() ? '[' + shown + ']' : shown) + ':' + std::to_string(address.port);
}

}  // namespace geminga::client
