// The time until the hosts of a lab are told of something.
#ifndef GEMINGA_TESTS_BENCH_DISCOVERY_TOLD_HPP
#define GEMINGA_TESTS_BENCH_DISCOVERY_TOLD_HPP

#include <cstddef>
#include <string>
#include <thread>
#include <vector>

#include "bench/times.hpp"
#include "support/lab_team.hpp"

namespace geminga::bench {

/// The delay of a host that was not told in time.
inline constexpr double never_ms = 1e6;

/// The time from `change` on this host until each other host prints a line with this text, by host; that of the host
/// itself is 0.
template <typename Change>
[[nodiscard]] std::vector<double> times_until_told(system::LabTeam& team, std::size_t host, const std::string& text,
                                                   Change change) {
  std::vector<double> times(team.size());
  const auto began = Clock::now();
  change();
  std::vector<std::jthread> watchers;
  for (std::size_t other = 0; other < team.size(); ++other) {
    if (other == host) continue;
    watchers.emplace_back([&, other] {
      const bool is_told = team.module(other).line_with({text}).has_value();
      times[other] = is_told ? milliseconds_since(began) : never_ms;
    });
  }
  for (std::jthread& watcher : watchers) watcher.join();
  return times;
}

}  // namespace geminga::bench

#endif
