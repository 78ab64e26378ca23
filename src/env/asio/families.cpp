#include "env/asio/families.hpp"

#include <algorithm>
#include <utility>

namespace geminga::env {
namespace {

using boost::asio::ip::address;

/// Kernels number their interfaces by positive ints.
constexpr std::uint32_t ipv6_side_bit = std::uint32_t{1} << 31U;

bool has_family(const Link& link, bool is_v4) {
  return std::ranges::any_of(link.prefixes, [&](const Prefix& prefix) { return prefix.address.is_v4() == is_v4; });
}

std::vector<address> of_family(const std::vector<address>& groups, bool is_v4) {
  std::vector<address> chosen;
  std::ranges::copy_if(groups, std::back_inserter(chosen),
                       [&](const address& group) { return group.is_v4() == is_v4; });
  return chosen;
}

Link ipv6_side_of(Link link) {
  link.interface.ipv6_side_of = link.interface.index;
  link.interface.index = InterfaceIndex{static_cast<std::uint32_t>(link.interface.index) | ipv6_side_bit};
  std::erase_if(link.prefixes, [](const Prefix& prefix) { return prefix.address.is_v4(); });
  link.interface.addresses = announced_addresses(link.prefixes);
  return link;
}

}  // namespace

std::vector<Joined> by_family(const std::vector<Link>& links, const std::vector<address>& groups) {
  const auto v4 = of_family(groups, true);
  const auto v6 = of_family(groups, false);
  std::vector<Joined> joined;
  std::vector<Joined> ipv6_sides;
  for (const Link& link : links) {
    const bool on_v4 = has_family(link, true) && !v4.empty();
    const bool on_v6 = has_family(link, false) && !v6.empty();
    if (link.interface.is_loopback || !on_v6) {
      joined.push_back({link, groups});
    } else if (!on_v4) {
      joined.push_back({link, has_family(link, true) ? groups : v6});
    } else {
      joined.push_back({link, v4});
      ipv6_sides.push_back({ipv6_side_of(link), v6});
    }
  }
  std::ranges::move(ipv6_sides, std::back_inserter(joined));
  return joined;
}

}  // namespace geminga::env
