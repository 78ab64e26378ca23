#include "scenarios/seeds.hpp"

#include <algorithm>
#include <mutex>
#include <thread>
#include <vector>

#include "scenarios/simulation.hpp"

namespace geminga::scenarios {
namespace {

void add(Tally& tally, const Result& result, std::uint64_t done) {
  tally.simulated += result.simulated;
  tally.false_departures += result.false_departures;
  tally.deaths.insert(tally.deaths.end(), result.delays.crashed.begin(), result.delays.crashed.end());
  tally.octets_per_host_second +=
      (result.octets_per_host_second() - tally.octets_per_host_second) / static_cast<double>(done);
}

}  // namespace

std::optional<Failure> run_seeds(const Seeds& seeds, std::size_t threads,
                                 const std::function<Conditions(std::uint64_t seed)>& conditions,
                                 const Progress& progress, Tally* tally) {
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
      if (tally != nullptr) add(*tally, result, done);
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
