// Many runs, several at once, until one finds something.
#ifndef GEMINGA_TESTS_SCENARIOS_SEEDS_HPP
#define GEMINGA_TESTS_SCENARIOS_SEEDS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "scenarios/conditions.hpp"

namespace geminga::scenarios {

/// Seeds that are run one after the other.
struct Seeds {
  std::uint64_t first = 1;
  std::uint64_t last = 1;
};

/// Called from one thread at a time, now and then: how many seeds are done.
using Progress = std::function<void(std::uint64_t done)>;

/// The sum of all runs.
struct Tally {
  base::Duration simulated{};
  std::size_t false_departures = 0;
  std::vector<base::Duration> deaths;  ///< how late each host was told of each
  double octets_per_host_second = 0;   ///< the mean of the runs
};

/// The least seed that finds a violation, and the first one.
struct Failure {
  std::uint64_t seed = 0;
  std::string violation;
};

/// Runs each seed once on so many threads. Where one fails, those that are under way come to their end and no other one
/// begins; so all seeds before the failure were run. `tally`: where all runs are summed up; may be null.
[[nodiscard]] std::optional<Failure> run_seeds(const Seeds& seeds, std::size_t threads,
                                               const std::function<Conditions(std::uint64_t seed)>& conditions,
                                               const Progress& progress = {}, Tally* tally = nullptr);

}  // namespace geminga::scenarios

#endif
