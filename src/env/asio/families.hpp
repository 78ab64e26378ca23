// On which groups an interface speaks and listens: IPv4, IPv6, or both as two interfaces.
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

/// The links with the groups of the families that they have addresses of. A link that speaks both is there twice, as
/// itself with the IPv4 groups and as its twin (Interface::twin_of) with the IPv6 ones; twins come last. Who has no
/// address of a family cannot answer what he hears there. The loopback joins all, and so does a link for whose
/// addresses there is no group: both are heard for what they are worth, and neither has a twin.
[[nodiscard]] std::vector<Joined> by_family(const std::vector<Link>& links,
                                            const std::vector<boost::asio::ip::address>& groups);

}  // namespace geminga::env

#endif
