// Monotonic time as every part of Geminga sees it: instants that only Env can make, and chrono durations.
#ifndef GEMINGA_BASE_TIME_HPP
#define GEMINGA_BASE_TIME_HPP

#include <chrono>

namespace geminga::base {

using Duration = std::chrono::nanoseconds;

/// The clock of Instant. It cannot be read: now() belongs to Env, so that a simulator can own the time.
struct MonotonicClock {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<MonotonicClock>;
  static constexpr bool is_steady = true;
};

/// A point of monotonic time. Instants of different processes cannot be compared.
using Instant = MonotonicClock::time_point;

/// Later than every instant: "never".
inline constexpr Instant never = Instant::max();

}  // namespace geminga::base

#endif
