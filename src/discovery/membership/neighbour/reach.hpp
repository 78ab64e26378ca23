// How a known participant can be reached, as a relay sees it.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_REACH_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_REACH_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/time.hpp"
#include "discovery/membership/neighbour/neighbour_way.hpp"
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
};

}  // namespace geminga::membership

#endif
