// The time in which a newcomer knows a site beyond a server.
#ifndef GEMINGA_TESTS_BENCH_DISCOVERY_OVER_SERVER_HPP
#define GEMINGA_TESTS_BENCH_DISCOVERY_OVER_SERVER_HPP

#include <cstddef>

namespace geminga::bench {

/// A site of all hosts but one, sealed, whose relay has a bridge to a server of NATS. The last host has a bridge to it
/// and no other link; its daemon is started five times. Prints the time until it is told of all services.
void measure_over_server(std::size_t hosts);

/// A site of so many participants with three services each, played by one program behind its relay, and a newcomer that
/// has nothing but a server of NATS between itself and them, started five times. `keeps`: the server has JetStream, so
/// that words are kept. Prints the time until it is told of one service of each, and the octets that reach it.
void measure_crowd_over_server(std::size_t count, bool keeps);

}  // namespace geminga::bench

#endif
