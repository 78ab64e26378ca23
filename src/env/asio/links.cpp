#include "env/asio/links.hpp"

#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <netpacket/packet.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>

#include "env/asio/virtual_links.hpp"

namespace geminga::env {
namespace {

namespace ip = boost::asio::ip;

unsigned leading_ones(const unsigned char* bytes, std::size_t count) {
  unsigned ones = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto here = static_cast<unsigned>(std::countl_one(bytes[i]));
    ones += here;
    if (here < 8) break;
  }
  return ones;
}

/// The address of one entry of getifaddrs(), without scope, and its prefix; nothing if it is of another family.
std::optional<Prefix> prefix_of(const ifaddrs& entry) {
  if (entry.ifa_addr == nullptr || entry.ifa_netmask == nullptr) return std::nullopt;
  if (entry.ifa_addr->sa_family == AF_INET) {
    sockaddr_in address{};
    sockaddr_in mask{};
    std::memcpy(&address, entry.ifa_addr, sizeof address);
    std::memcpy(&mask, entry.ifa_netmask, sizeof mask);
    unsigned char bits[4];
    std::memcpy(bits, &mask.sin_addr, sizeof bits);
    return Prefix{ip::address_v4(ntohl(address.sin_addr.s_addr)), leading_ones(bits, sizeof bits)};
  }
  if (entry.ifa_addr->sa_family == AF_INET6) {
    sockaddr_in6 address{};
    sockaddr_in6 mask{};
    std::memcpy(&address, entry.ifa_addr, sizeof address);
    std::memcpy(&mask, entry.ifa_netmask, sizeof mask);
    ip::address_v6::bytes_type bytes;
    std::memcpy(bytes.data(), &address.sin6_addr, bytes.size());
    return Prefix{ip::address_v6(bytes), leading_ones(mask.sin6_addr.s6_addr, 16)};
  }
  return std::nullopt;
}

bool is_wanted(const ifaddrs& entry, const std::vector<std::string>& names) {
  constexpr unsigned up = IFF_UP | IFF_RUNNING;
  if ((entry.ifa_flags & up) != up) return false;
  if (!names.empty()) return std::ranges::find(names, entry.ifa_name) != names.end();
  return (entry.ifa_flags & IFF_MULTICAST) != 0 && (entry.ifa_flags & IFF_LOOPBACK) == 0;
}

bool share_prefix(const ip::address& a, const Prefix& prefix) {
  const auto same = [&](const auto& x, const auto& y) {
    for (unsigned bit = 0; bit < prefix.length; ++bit) {
      const unsigned mask = 0x80U >> (bit % 8U);
      if ((x[bit / 8U] & mask) != (y[bit / 8U] & mask)) return false;
    }
    return true;
  };
  if (a.is_v4() != prefix.address.is_v4()) return false;
  if (a.is_v4()) return same(a.to_v4().to_bytes(), prefix.address.to_v4().to_bytes());
  return same(a.to_v6().to_bytes(), prefix.address.to_v6().to_bytes());
}

bool is_link_local(const ip::address& address) { return address.is_v6() && address.to_v6().is_link_local(); }

}  // namespace

std::vector<std::string> announced_addresses(const std::vector<Prefix>& prefixes) {
  std::vector<std::string> addresses;
  const auto take = [&](auto&& wanted) {
    for (const Prefix& prefix : prefixes) {
      if (wanted(prefix.address) && addresses.size() < max_addresses_per_link) {
        addresses.push_back(prefix.address.to_string());
      }
    }
  };
  take([](const ip::address& address) { return address.is_v4(); });
  take([](const ip::address& address) { return address.is_v6() && !is_link_local(address); });
  if (addresses.empty()) take([](const ip::address& address) { return is_link_local(address); });
  return addresses;
}

std::vector<std::string> announced_on(const Interface& interface, const std::vector<AnnouncedAddress>& all) {
  std::vector<std::string> addresses;
  for (const std::string& name : {interface.name, std::string()}) {
    for (const AnnouncedAddress& one : all) {
      if (one.interface == name && addresses.size() < max_addresses_per_link) addresses.push_back(one.address);
    }
    if (!addresses.empty()) break;
  }
  return addresses;
}

std::optional<ip::address_v4> Link::first_v4() const {
  const auto found = std::ranges::find_if(prefixes, [](const Prefix& prefix) { return prefix.address.is_v4(); });
  if (found == prefixes.end()) return std::nullopt;
  return found->address.to_v4();
}

bool Link::has_address(const ip::address& address) const {
  return std::ranges::any_of(prefixes, [&](const Prefix& prefix) { return prefix.address == address; });
}

bool Link::has_network_of(const ip::address& address) const {
  return std::ranges::any_of(prefixes, [&](const Prefix& prefix) { return share_prefix(address, prefix); });
}

bool Link::is_on_link(const ip::address& source) const {
  if (interface.is_loopback || is_link_local(source) || has_network_of(source)) return true;
  return std::ranges::none_of(prefixes, [&](const Prefix& prefix) {
    return prefix.address.is_v4() == source.is_v4() && !is_link_local(prefix.address);
  });
}

std::optional<InterfaceIndex> link_of(const ifaddrs& entry) {
  if (entry.ifa_addr == nullptr) {
    const unsigned index = ::if_nametoindex(entry.ifa_name);
    if (index == 0) return std::nullopt;  // it has just gone
    return InterfaceIndex{index};
  }
  if (entry.ifa_addr->sa_family != AF_PACKET) return std::nullopt;
  sockaddr_ll packet{};
  std::memcpy(&packet, entry.ifa_addr, sizeof packet);
  return InterfaceIndex{static_cast<std::uint32_t>(packet.sll_ifindex)};
}

std::vector<std::string> take_ignored(std::vector<LinkRank>& found) {
  std::vector<std::string> ignored;
  std::ranges::sort(found, {}, [](const LinkRank& one) { return std::pair(one.is_virtual, one.index); });
  for (std::size_t i = max_links; i < found.size(); ++i) ignored.push_back(found[i].name);
  if (found.size() > max_links) found.resize(max_links);
  std::ranges::sort(found, {}, &LinkRank::index);
  return ignored;
}

std::expected<LinkScan, std::string> scan_links(const std::vector<std::string>& names) {
  ifaddrs* raw = nullptr;
  if (::getifaddrs(&raw) != 0) return std::unexpected(std::generic_category().message(errno));
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> entries(raw, &::freeifaddrs);
  std::vector<LinkRank> found;
  for (const ifaddrs* entry = entries.get(); entry != nullptr; entry = entry->ifa_next) {
    const auto index = link_of(*entry);
    if (index && is_wanted(*entry, names)) found.push_back({.index = *index, .name = entry->ifa_name});
  }
  LinkScan scan;
  if (found.size() > max_links) {
    const auto virtual_ones = virtual_links();
    if (!virtual_ones) return std::unexpected(virtual_ones.error());
    for (LinkRank& one : found) one.is_virtual = virtual_ones->contains(one.index);
  }
  scan.ignored = take_ignored(found);
  for (LinkRank& one : found) {
    Link link;
    link.interface.index = one.index;
    link.interface.name = std::move(one.name);
    scan.links.push_back(std::move(link));
  }
  for (const ifaddrs* entry = entries.get(); entry != nullptr; entry = entry->ifa_next) {
    const std::string_view labelled(entry->ifa_name);  // an old-style alias is called eth0:1
    const std::string_view name = labelled.substr(0, labelled.find(':'));
    const auto link = std::ranges::find_if(scan.links, [&](const Link& l) { return l.interface.name == name; });
    if (link == scan.links.end()) continue;
    link->interface.is_loopback = (entry->ifa_flags & IFF_LOOPBACK) != 0;
    if (const auto prefix = prefix_of(*entry)) link->prefixes.push_back(*prefix);
  }
  for (Link& link : scan.links) link.interface.addresses = announced_addresses(link.prefixes);
  return scan;
}

}  // namespace geminga::env
