#include "discovery/membership/neighbour/reach.hpp"

#include <algorithm>

#include "base/address.hpp"

namespace geminga::membership {
namespace {

/// Addresses of one interface that a host announces at most (env/asio/links.hpp). With as many it may have further
/// ones.
constexpr std::size_t most_announced = 4;

/// Whether a way leads past a translation of addresses, as far as its source tells.
bool differs(const NeighbourWay& way) {
  const auto source = base::parse_address(way.source());
  if (!source || source->scope() == base::AddressScope::link_local) return false;
  std::size_t alike = 0;
  for (const std::string& text : way.addresses()) {
    const auto address = base::parse_address(text);
    if (!address || address->is_ipv6() != source->is_ipv6()) continue;
    if (address->octets == source->octets) return false;
    ++alike;
  }
  return alike > 0 && way.addresses().size() < most_announced;
}

}  // namespace

std::string observed_address(const Reach& reach) {
  // A way that is known by presences alone has said no addresses.
  if (reach.ways.empty() || !std::ranges::all_of(reach.ways, differs)) return {};
  return reach.ways.front().source();
}

}  // namespace geminga::membership
