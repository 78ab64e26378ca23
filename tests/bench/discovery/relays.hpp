// The measurements of a team on three links, with relays and a translation of addresses between them.
#ifndef GEMINGA_TESTS_BENCH_DISCOVERY_RELAYS_HPP
#define GEMINGA_TESTS_BENCH_DISCOVERY_RELAYS_HPP

namespace geminga::bench {

/// Three links of ten hosts each. A relay is on the first and the second link. The second and the third one have a
/// relay each, which name each other by --peer, and between these a router translates addresses. `loss`: the share of
/// what is sent on a link that each receiver misses. Prints its rows: how soon others are told over how many relays,
/// how many are lost by mistake in so many seconds, and when all is right after a relay's restart. Requires
/// Lab::can_lose().
void measure_relays(double loss, int changes, int quiet_seconds);

}  // namespace geminga::bench

#endif
