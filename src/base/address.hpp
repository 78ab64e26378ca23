// Numeric IP addresses and their scopes, which decide what may be told to whom (paper sections 3.5.2 and 3.6).
#ifndef GEMINGA_BASE_ADDRESS_HPP
#define GEMINGA_BASE_ADDRESS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::base {

/// The scope within which an address means the same host. Addresses are compared by scope equivalence (paper section
/// 3.6).
enum class AddressScope : std::uint8_t {
  unspecified,  ///< 0.0.0.0 and ::, at which no host can be reached
  loopback,     ///< 127.0.0.0/8 and ::1
  link_local,   ///< 169.254.0.0/16 and fe80::/10
  private_use,  ///< RFC 1918, 100.64.0.0/10 and fc00::/7
  global,       ///< every other unicast address
  multicast,    ///< 224.0.0.0/4 and ff00::/8
};

/// A parsed address: 4 or 16 octets in network order, with the zone if it is an IPv6 link-local one that has one.
struct Address {
  std::vector<std::uint8_t> octets;
  std::string zone;

  [[nodiscard]] bool is_ipv6() const { return octets.size() == 16; }
  [[nodiscard]] AddressScope scope() const;
  /// The canonical text (RFC 5952 for IPv6), with `%zone` if there is one.
  [[nodiscard]] std::string text() const;
  friend auto operator<=>(const Address&, const Address&) = default;
};

/// The address of a numeric text, or nothing. IPv4 has four decimal parts; IPv6 may have every form of RFC 4291; only
/// an IPv6 link-local address may have a zone.
[[nodiscard]] std::optional<Address> parse_address(std::string_view text);
/// The scope of a numeric text, or nothing.
[[nodiscard]] std::optional<AddressScope> address_scope(std::string_view text);

/// The rank of an address among several of one host: a consumer is given the one with the smallest. IPv4 comes before
/// IPv6; within each, private and global addresses before link-local ones; loopback after all of them.
[[nodiscard]] int address_rank(const Address& address);

}  // namespace geminga::base

#endif
