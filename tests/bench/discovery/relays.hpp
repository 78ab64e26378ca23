// The measurements of a team on three links, with relays and a translation of addresses between them.
#ifndef GEMINGA_TESTS_BENCH_DISCOVERY_RELAYS_HPP
#define GEMINGA_TESTS_BENCH_DISCOVERY_RELAYS_HPP

#include <cstddef>

namespace geminga::bench {

/// How large the team is, and how long it is looked at.
struct RelayEffort {
  std::size_t on_link = 10;  ///< hosts on each link; three at least
  int changes = 30;
  int quiet_seconds = 100;
  int settling = 5000;         ///< milliseconds until a team has settled
  int until_given_up = 20000;  ///< milliseconds until all have noticed a death
};

/// Three links of so many hosts each. A relay is on the first and the second link. The second and the third one have a
/// relay each, which name each other by --peer, and between these a router translates addresses. `loss`: the share of
/// what is sent on a link that each receiver misses. Prints its rows: how soon others are told over how many relays,
/// how many are lost by mistake in so many seconds, and when all is right after a relay's restart. False: what
/// somebody knows did not come to be right. Requires Lab::can_lose().
[[nodiscard]] bool measure_relays(double loss, const RelayEffort& effort);

}  // namespace geminga::bench

#endif
