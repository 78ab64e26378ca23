// Whether the address of a participant can be reached from here, as far as that is certain.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_REACHABILITY_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_REACHABILITY_HPP

#include <cstdint>
#include <functional>
#include <string>

namespace geminga::membership {

enum class Reachability : std::uint8_t {
  reachable,   ///< nothing is known that stands against it
  no_route,    ///< this host has no route to the address
  translated,  ///< the address belongs to a network behind a translation of addresses
};

/// Judges the address of a participant that is heard from afar. `observed` is the address from which its words come
/// where it does not announce that; else empty.
using JudgeReach = std::function<Reachability(const std::string& address, const std::string& observed)>;

}  // namespace geminga::membership

#endif
