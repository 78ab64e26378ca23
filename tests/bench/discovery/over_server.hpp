// The time in which a newcomer knows a site beyond a server.
#ifndef GEMINGA_TESTS_BENCH_DISCOVERY_OVER_SERVER_HPP
#define GEMINGA_TESTS_BENCH_DISCOVERY_OVER_SERVER_HPP

#include <cstddef>

namespace geminga::bench {

/// A site of all hosts but one, sealed, whose relay has a bridge to a server of NATS. The last host has a bridge to it
/// and no other link; its daemon is started five times. Prints the time until it is told of all services.
void measure_over_server(std::size_t hosts);

}  // namespace geminga::bench

#endif
