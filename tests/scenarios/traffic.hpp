// The checker of what hosts send: never more than the schedule allows, and little while nothing happens.
#ifndef GEMINGA_TESTS_SCENARIOS_TRAFFIC_HPP
#define GEMINGA_TESTS_SCENARIOS_TRAFFIC_HPP

#include <cstdint>
#include <vector>

#include "base/time.hpp"
#include "sim/world.hpp"

namespace geminga::scenarios {

/// The datagrams, of all kinds together, that a host may send within a window. See README.md beside this file for the
/// sum.
inline constexpr base::Duration traffic_window = std::chrono::seconds(10);
inline constexpr std::uint64_t most_datagrams = 600;

/// Of each datagram on the air: Ethernet, IPv4 and UDP.
inline constexpr std::uint64_t header_octets = 42;

class Traffic {
 public:
  /// Looks at all hosts at the end of each window, for as long as the world runs.
  explicit Traffic(sim::World& world, std::uint64_t most = most_datagrams);

 private:
  void check();

  sim::World& world_;
  std::uint64_t most_;
  std::vector<std::uint64_t> sent_;  ///< until the last window, by host
};

}  // namespace geminga::scenarios

#endif
