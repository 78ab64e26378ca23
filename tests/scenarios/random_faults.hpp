// Faults at times and on hosts that chance chooses.
#ifndef GEMINGA_TESTS_SCENARIOS_RANDOM_FAULTS_HPP
#define GEMINGA_TESTS_SCENARIOS_RANDOM_FAULTS_HPP

#include <cstdint>

#include "base/random.hpp"
#include "scenarios/conditions.hpp"
#include "scenarios/script.hpp"

namespace geminga::scenarios {

/// How often each fault comes in a run, at times and on hosts that the seed chooses.
struct Counts {
  unsigned restarts = 0;
  unsigned crashes = 0;
  unsigned sleeps = 0;
  unsigned partitions = 0;
  unsigned deaf = 0;
  unsigned lies = 0;
};

/// So many of each, between the tenth second and the last ten seconds of this time.
void write_faults(Script& script, base::Random& random, const Counts& counts, base::Duration time);

/// A small team, an air, and faults of all kinds: what the nightly run walks through. The same seed gives the same one.
[[nodiscard]] Conditions random_conditions(std::uint64_t seed);

}  // namespace geminga::scenarios

#endif
