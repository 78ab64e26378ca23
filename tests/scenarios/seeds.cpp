#include "scenarios/seeds.hpp"

#include <algorithm>
#include <mutex>
#include <thread>
#include <vector>

#include "scenarios/simulation.hpp"

namespace geminga::scenarios {

std::optional<Failure> run_seeds(const Seeds& seeds, std::size_t threads,
                                 const std::function<Conditions(std::uint64_t seed)>& conditions,
                                 const Progress& progress) {
  std::mutex mutex;
  std::uint64_t next = seeds.first;
  std::uint64_t done = 0;
  std::optional<Failure> failure;
  const auto work = [&] {
    for (;;) {
      std::uint64_t seed = 0;
      {
        const std::lock_guard lock(mutex);
        if (failure || next > seeds.last) return;
        seed = next++;
      }
      const Conditions one = conditions(seed);
      const Result result = simulate(one);
      const std::lock_guard lock(mutex);
      ++done;
      if (progress) progress(done);
      if (result.violations.empty() || (failure && failure->seed < seed)) continue;
      failure = {.seed = seed, .violation = result.violations.front()};
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < std::max<std::size_t>(threads, 1); ++i) workers.emplace_back(work);
  }
  return failure;
}

}  // namespace geminga::scenarios
