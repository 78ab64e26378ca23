// The conditions of one simulated run.
#ifndef GEMINGA_TESTS_SCENARIOS_CONDITIONS_HPP
#define GEMINGA_TESTS_SCENARIOS_CONDITIONS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "base/random.hpp"
#include "base/time.hpp"
#include "sim/air.hpp"

namespace geminga::scenarios {

class Script;

/// The same conditions give the same run on every machine.
struct Conditions {
  /// A named scenario; empty: what the flags say.
  std::string name;
  std::uint64_t seed = 1;
  std::size_t participants = 10;
  base::Duration time = std::chrono::minutes(10);
  sim::Air air;
  base::Duration interval = std::chrono::seconds(2);
  /// Publications of a participant, and about as many subscriptions. 0: those of a robot of the paper (nine and seven)
  /// up to sixty participants, one and one beyond, since each participant keeps those of all others.
  std::size_t services = 0;
  /// Services that begin somewhere in the team in a minute. Each is withdrawn again after 5 to 30 s.
  unsigned changes_per_minute = 6;
  /// Of a start that is measured (starts.hpp): daemons begin within this time, and their modules within twice as long.
  base::Duration start_spread{};
  /// Each clock gains or loses up to so many millionths.
  std::int64_t drift = 0;
  /// Writes what goes wrong and when; empty: nothing does but the air.
  std::function<void(Script& script, base::Random& random)> write;
};

}  // namespace geminga::scenarios

#endif
