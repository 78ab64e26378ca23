// The host's virtual interfaces: bridges, the ends of containers, tunnels.
#ifndef GEMINGA_ENV_ASIO_VIRTUAL_LINKS_HPP
#define GEMINGA_ENV_ASIO_VIRTUAL_LINKS_HPP

#include <cstddef>
#include <expected>
#include <set>
#include <span>
#include <string>

#include "env/env.hpp"

namespace geminga::env {

/// The interfaces to which the kernel gives a kind ("veth", "bridge", "tun"), as rtnetlink(7) tells: those that have no
/// device of their own. Wired and wireless ones have none. Opens no file. The error says why the system does not tell.
[[nodiscard]] std::expected<std::set<InterfaceIndex>, std::string> virtual_links();

/// Reads one datagram of the kernel's answer, and adds the virtual interfaces in it. False: it was the last one.
[[nodiscard]] bool add_virtual_links(std::span<const std::byte> answer, std::set<InterfaceIndex>& found);

}  // namespace geminga::env

#endif
