// The verdict on whether the address of a participant can be reached from here.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_REACH_JUDGE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_REACH_JUDGE_HPP

#include <string>
#include <string_view>

#include "discovery/membership/neighbour/reachability.hpp"
#include "env/route_kind.hpp"

namespace geminga::participant {

/// Judges an address by this host's route to it. A wrong verdict costs a match, so what is not certain is reachable:
///
/// - no route at all: it cannot be reached.
/// - the default route alone, and an address for private use (RFC 1918, RFC 6598, RFC 4193, link-local) whose host's
///   words come from another one: a translation lies between, and the default route leads to somebody else's network.
/// - everything else can be reached, as far as we know: a router that is named for a private network knows it.
[[nodiscard]] membership::Reachability judged_reach(std::string_view address, std::string_view observed,
                                                    env::RouteKind route);

}  // namespace geminga::participant

#endif
