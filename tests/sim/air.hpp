// How the air is: what it loses, delays, copies and spoils.
#ifndef GEMINGA_TESTS_SIM_AIR_HPP
#define GEMINGA_TESTS_SIM_AIR_HPP

#include "base/time.hpp"

namespace geminga::sim {

/// Every receiver's fortune is drawn for itself, as with radio. Shares are between 0 and 1.
struct Air {
  double loss = 0;       ///< share of datagrams that a receiver misses, each by itself
  double duplicate = 0;  ///< share that comes twice
  base::Duration shortest_delay = std::chrono::microseconds(200);
  base::Duration longest_delay = std::chrono::milliseconds(2);  ///< longer than a gap between two datagrams: reorders
  /// Share of the time that falls into bursts, in which a receiver misses everything, and how long a burst takes on
  /// average (Gilbert and Elliott's two states). Beside `loss`.
  double burst = 0;
  base::Duration burst_length = std::chrono::milliseconds(300);
  /// Share that comes later than the rest, by up to `lateness`: later ones overtake it. ANNOUNCEMENT.md relies on at
  /// most 200 ms (announcement::overtaken_time).
  double late = 0;
  base::Duration lateness = std::chrono::milliseconds(150);
  /// Share of which one to eight bits are turned over. The checksum of UDP hides nearly all of them from a participant;
  /// here it sees every one.
  double flip = 0;
};

}  // namespace geminga::sim

#endif
