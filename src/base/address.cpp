#include "base/address.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>

#include "base/text.hpp"

namespace geminga::base {
namespace {

/// The longest name of an interface, and so of a zone (IFNAMSIZ without its NUL).
constexpr std::size_t max_zone_bytes = 15;

AddressScope ipv4_scope(const std::vector<std::uint8_t>& octets) {
  const auto a = octets[0];
  const auto b = octets[1];
  if (std::ranges::all_of(octets, [](std::uint8_t octet) { return octet == 0; })) return AddressScope::unspecified;
  if (a == 127) return AddressScope::loopback;
  if (a == 169 && b == 254) return AddressScope::link_local;
  if (a == 10 || (a == 172 && (b & 0xf0) == 16) || (a == 192 && b == 168) || (a == 100 && (b & 0xc0) == 64)) {
    return AddressScope::private_use;
  }
  return (a & 0xf0) == 224 ? AddressScope::multicast : AddressScope::global;
}

AddressScope ipv6_scope(const std::vector<std::uint8_t>& octets) {
  if (std::all_of(octets.begin(), octets.end() - 1, [](std::uint8_t octet) { return octet == 0; })) {
    if (octets.back() == 0) return AddressScope::unspecified;
    if (octets.back() == 1) return AddressScope::loopback;
  }
  if (octets[0] == 0xff) return AddressScope::multicast;
  if (octets[0] == 0xfe && (octets[1] & 0xc0) == 0x80) return AddressScope::link_local;
  return (octets[0] & 0xfe) == 0xfc ? AddressScope::private_use : AddressScope::global;
}

bool is_zone(std::string_view zone) {
  return !zone.empty() && zone.size() <= max_zone_bytes && is_valid_utf8(zone) && !has_control_character(zone) &&
         zone.find_first_of(" /%,\"") == std::string_view::npos;
}

}  // namespace

AddressScope Address::scope() const { return is_ipv6() ? ipv6_scope(octets) : ipv4_scope(octets); }

std::string Address::text() const {
  std::array<char, INET6_ADDRSTRLEN> buffer{};
  if (::inet_ntop(is_ipv6() ? AF_INET6 : AF_INET, octets.data(), buffer.data(), buffer.size()) == nullptr) return {};
  std::string text = buffer.data();
  if (!zone.empty()) text += '%' + zone;
  return text;
}

std::optional<Address> parse_address(std::string_view text) {
  const auto percent = text.find('%');
  // inet_pton() reads a C string: a NUL inside must not hide what is behind it.
  const std::string number(text.substr(0, percent));
  if (number.size() >= INET6_ADDRSTRLEN || number.find('\0') != std::string::npos) return std::nullopt;
  Address address;
  std::array<std::uint8_t, sizeof(in6_addr)> octets{};
  if (::inet_pton(AF_INET, number.c_str(), octets.data()) == 1) {
    address.octets.assign(octets.begin(), octets.begin() + sizeof(in_addr));
  } else if (::inet_pton(AF_INET6, number.c_str(), octets.data()) == 1) {
    address.octets.assign(octets.begin(), octets.end());
  } else {
    return std::nullopt;
  }
  if (percent != std::string_view::npos) {
    const auto zone = text.substr(percent + 1);
    if (!address.is_ipv6() || address.scope() != AddressScope::link_local || !is_zone(zone)) return std::nullopt;
    address.zone = zone;
  }
  return address;
}

std::optional<AddressScope> address_scope(std::string_view text) {
  const auto address = parse_address(text);
  return address ? std::optional(address->scope()) : std::nullopt;
}

int address_rank(const Address& address) {
  const auto scope = address.scope();
  const int family = address.is_ipv6() ? 1 : 0;
  if (scope == AddressScope::unspecified || scope == AddressScope::multicast) return 6;
  if (scope == AddressScope::loopback) return 4 + family;
  return 2 * family + (scope == AddressScope::link_local ? 1 : 0);
}

}  // namespace geminga::base
