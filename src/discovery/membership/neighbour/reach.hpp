// How a known participant can be reached, as a relay sees it.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_REACH_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_REACH_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/time.hpp"
#include "discovery/membership/neighbour/neighbour_way.hpp"
#include "discovery/membership/neighbour/reachability.hpp"
#include "env/env.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// A participant with the ways that lead to it, for a relay. Borrowed from the table until it changes.
struct Reach {
  ParticipantId id{};
  std::uint64_t revision = 0;  ///< the last one whose state is known in whole; 0: none
  base::Instant heard;         ///< when it last spoke, as far as we and witnesses know
  base::Duration interval{};
  double loss = 0;               ///< of its datagrams, on all hops together
  std::size_t hops = 0;          ///< relays between it and us; 0: it is heard directly
  env::InterfaceIndex beyond{};  ///< with hops: the interface of ours that the last relay speaks on
  std::span<const NeighbourWay> ways;
  Reachability reachability = Reachability::reachable;  ///< of the address that its services are told with
};

/// The address from which the words of a participant come where it announces another one of that kind (IPv4, IPv6) on
/// each of its ways; empty: there is none. A translation of addresses lies between, or it announces what it was told to
/// (announce-address). A link-local address says nothing, since a relay passes none of these on.
[[nodiscard]] std::string observed_address(const Reach& reach);

}  // namespace geminga::membership

#endif
