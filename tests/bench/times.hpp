// Times as benchmarks show them.
#ifndef GEMINGA_TESTS_BENCH_TIMES_HPP
#define GEMINGA_TESTS_BENCH_TIMES_HPP

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace geminga::bench {

using Clock = std::chrono::steady_clock;

[[nodiscard]] inline double milliseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

[[nodiscard]] inline double milliseconds_since(Clock::time_point began) { return milliseconds(Clock::now() - began); }

/// The value that this share of them does not exceed; 1 gives the largest, no values give 0.
[[nodiscard]] inline double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.empty() ? 0 : values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

}  // namespace geminga::bench

#endif
