// The host's network interfaces as the kernel shows them at this moment, with their addresses and networks.
#ifndef GEMINGA_ENV_ASIO_LINKS_HPP
#define GEMINGA_ENV_ASIO_LINKS_HPP

#include <boost/asio/ip/address.hpp>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "env/env.hpp"

struct ifaddrs;

namespace geminga::env {

/// An address of an interface, and the length of its network's prefix.
struct Prefix {
  boost::asio::ip::address address;
  unsigned length = 0;
  friend bool operator==(const Prefix&, const Prefix&) = default;
};

/// One interface in use: what the participant sees of it, and every address with its prefix, link-local ones included.
struct Link {
  Interface interface;
  std::vector<Prefix> prefixes;
  friend bool operator==(const Link&, const Link&) = default;

  [[nodiscard]] std::optional<boost::asio::ip::address_v4> first_v4() const;
  [[nodiscard]] bool has_address(const boost::asio::ip::address& address) const;
  /// Whether the address is in one of the interface's networks.
  [[nodiscard]] bool has_network_of(const boost::asio::ip::address& address) const;
  /// Whether a datagram from this source can have been sent on this very link: it is in one of the interface's
  /// networks, or link-local. True if the interface is the loopback, or has no address of that family to judge by.
  [[nodiscard]] bool is_on_link(const boost::asio::ip::address& source) const;
};

/// The most interfaces in use. A robot has two or three, and as many virtual ones as it runs containers.
inline constexpr std::size_t max_links = 64;
/// The most addresses of one interface that are announced. More would only make announcements longer.
inline constexpr std::size_t max_addresses_per_link = 4;

/// The addresses that are announced: IPv4 first, then IPv6; link-local ones only if there is nothing else; at most
/// max_addresses_per_link.
[[nodiscard]] std::vector<std::string> announced_addresses(const std::vector<Prefix>& prefixes);

/// An address that is announced though no interface has it, as behind a translation of addresses.
struct AnnouncedAddress {
  std::string interface;  ///< the interface on which it stands for the own ones; empty: on all
  std::string address;    ///< numeric
  friend bool operator==(const AnnouncedAddress&, const AnnouncedAddress&) = default;
};
inline constexpr std::size_t max_announced_addresses = 16;
/// Those that are announced on an interface: those for it alone, else those for all; at most max_addresses_per_link.
[[nodiscard]] std::vector<std::string> announced_on(const Interface& interface,
                                                    const std::vector<AnnouncedAddress>& all);

/// The interface that an entry of getifaddrs() describes as a whole, not by one of its IP addresses: the entry has the
/// address of the link layer, or none if the link layer has none (TUN).
[[nodiscard]] std::optional<InterfaceIndex> link_of(const ifaddrs& entry);

/// The interfaces in use, and the names of those for which there is no room.
struct LinkScan {
  std::vector<Link> links;  ///< ordered by index
  std::vector<std::string> ignored;
};

/// An interface as chosen among: its index, and whether it is a virtual one.
struct LinkRank {
  InterfaceIndex index{};
  std::string name;
  bool is_virtual = false;
};

/// Takes out those for which there is no room, and gives their names: virtual ones before others, and of these the
/// greater index first. Orders the rest by index.
[[nodiscard]] std::vector<std::string> take_ignored(std::vector<LinkRank>& found);

/// The interfaces that are up and running and can multicast, without the loopback. If `names` is not empty: those with
/// these names, of any kind, if they are up. Ordered by index. An IPv6 link-local address is announced only if there is
/// no other address: without a scope nobody else can use it. At most max_links. The error says why the system does not
/// tell, as when it has no descriptor left. Cost: two netlink dumps, and one more where there are many.
[[nodiscard]] std::expected<LinkScan, std::string> scan_links(const std::vector<std::string>& names);

}  // namespace geminga::env

#endif
