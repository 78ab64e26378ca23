#include "discovery/announcement/on_interface.hpp"

#include <algorithm>

#include "base/address.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

std::uint32_t link_of(const env::Interface& interface) {
  const auto number = static_cast<std::uint32_t>(interface.ipv6_side_of.value_or(interface.index));
  return interface.ipv6_side_of ? number | ipv6_side_bit : number;
}

/// The canonical text without its zone; a text that is no address stays as it is.
std::string without_zone(const std::string& text) {
  auto address = base::parse_address(text);
  if (!address) return text;
  address->zone.clear();
  return address->text();
}

bool has_address(const env::Interface& interface, const base::Address& address) {
  return std::ranges::any_of(interface.addresses, [&](const std::string& text) {
    const auto own = base::parse_address(text);
    return own && own->octets == address.octets;
  });
}

}  // namespace

bool is_announced_on(std::string_view text, const env::Interface& interface, std::span<const env::Interface> ours) {
  const auto address = base::parse_address(text);
  if (!address) return text.empty();
  if (!address->zone.empty()) return address->zone == interface.name;
  if (address->scope() == base::AddressScope::loopback) return interface.is_loopback;
  if (has_address(interface, *address)) return true;
  return std::ranges::none_of(ours, [&](const env::Interface& other) { return has_address(other, *address); });
}

Announcement on_interface(Announcement state, const env::Interface& interface, std::span<const env::Interface> ours) {
  state.link = link_of(interface);
  state.addresses.clear();
  for (const auto& text : interface.announced.empty() ? interface.addresses : interface.announced) {
    if (state.addresses.size() == max_addresses) break;
    if (base::parse_address(text)) state.addresses.push_back(without_zone(text));
  }
  for (auto& peer : state.peers) {
    const auto withhold = [&](const auto& numbered, const std::string& address) {
      if (is_announced_on(address, interface, ours)) return false;
      peer.withheld.push_back(numbered.number);
      return true;
    };
    std::erase_if(peer.publications, [&](auto& numbered) { return withhold(numbered, numbered.publication.address); });
    std::erase_if(peer.subscriptions,
                  [&](auto& numbered) { return withhold(numbered, numbered.subscription.address); });
    for (auto& numbered : peer.publications) numbered.publication.address = without_zone(numbered.publication.address);
    for (auto& numbered : peer.subscriptions) {
      numbered.subscription.address = without_zone(numbered.subscription.address);
    }
    std::ranges::sort(peer.withheld);
  }
  return state;
}

}  // namespace geminga::announcement
