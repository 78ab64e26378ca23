// Many runs, several at once, until one finds something.
#ifndef GEMINGA_TESTS_SCENARIOS_SEEDS_HPP
#define GEMINGA_TESTS_SCENARIOS_SEEDS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "scenarios/conditions.hpp"

namespace geminga::scenarios {

/// Seeds that are run one after the other.
struct Seeds {
  std::uint64_t first = 1;
  std::uint64_t last = 1;
};

/// Called from one thread at a time, now and then: how many seeds are done.
using Progress = std::function<void(std::uint64_t done)>;

/// The least seed that finds a violation, and the first one.
struct Failure {
  std::uint64_t seed = 0;
  std::string violation;
};

/// Runs each seed once on so many threads. Where one fails, those that are under way come to their end and no other one
/// begins; so all seeds before the failure were run.
[[nodiscard]] std::optional<Failure> run_seeds(const Seeds& seeds, std::size_t threads,
                                               const std::function<Conditions(std::uint64_t seed)>& conditions,
                                               const Progress& progress = {});

}  // namespace geminga::scenarios

#endif
