// Whether the address of a service can be reached from here, as `query why` and other queries say it.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_REACH_CHECK_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_REACH_CHECK_HPP

#include "discovery/membership/neighbours.hpp"
#include "discovery/participant/queries/checks.hpp"

namespace geminga::participant {

/// Checks the address of an offer for a request of this host; only where it cannot be reached from here.
[[nodiscard]] Check check_reach(const membership::Neighbours& neighbours, const Asked& asked,
                                const registry::PublicationEntry& offer);

}  // namespace geminga::participant

#endif
