// The groups that an interface joins: IPv4, IPv6, or both as two interfaces.
#ifndef GEMINGA_ENV_ASIO_FAMILIES_HPP
#define GEMINGA_ENV_ASIO_FAMILIES_HPP

#include <boost/asio/ip/address.hpp>
#include <vector>

#include "env/asio/links.hpp"

namespace geminga::env {

/// An interface with the groups that it joins.
struct Joined {
  Link link;
  std::vector<boost::asio::ip::address> groups;
};

/// The links with the groups of the families that they have addresses of. A dual-stack link is listed twice: itself
/// with the IPv4 groups, and its IPv6 side (Interface::ipv6_side_of) with the IPv6 groups. The IPv6 sides come last. A
/// host without an address of a family cannot answer there. The loopback joins all groups, and so does a link for whose
/// addresses there is no group; neither has an IPv6 side.
[[nodiscard]] std::vector<Joined> by_family(const std::vector<Link>& links,
                                            const std::vector<boost::asio::ip::address>& groups);

}  // namespace geminga::env

#endif
