// The monotonic clock of one host: it begins anywhere, runs a little too fast or too slow, and may stand still.
#ifndef GEMINGA_TESTS_SIM_CLOCK_HPP
#define GEMINGA_TESTS_SIM_CLOCK_HPP

#include <algorithm>
#include <cstdint>

#include "base/time.hpp"

namespace geminga::sim {

/// Whole numbers only, so that it is the same on every machine. Drift is in millionths, at most 50 000 either way (a
/// twentieth); so times of a day do not overflow.
class Clock {
 public:
  explicit Clock(base::Duration beginning) : local_(beginning) {}

  /// Its time at the instant `world`. Never falls.
  [[nodiscard]] base::Instant local(base::Instant world) const {
    if (is_stopped_) return base::Instant(local_);
    const base::Duration gone = world - world_;
    return base::Instant(local_ + gone + gone * drift_ / millionths);
  }
  /// The first time of the world at which it shows `local` or more, while nothing changes.
  [[nodiscard]] base::Instant world(base::Instant local_time) const {
    const base::Duration gone = local_time.time_since_epoch() - local_;
    if (gone <= base::Duration(0)) return world_;
    if (drift_ == 0) return world_ + gone;
    base::Instant found = world_ + gone - gone / (millionths + drift_) * drift_;
    while (local(found) > local_time) found -= std::max(base::Duration(1), (local(found) - local_time) / 2);
    while (local(found) < local_time) found += std::max(base::Duration(1), (local_time - local(found)) / 2);
    return found;
  }

  /// From now on it gains (or loses) so many millionths.
  void set_drift(base::Instant now, std::int64_t drift) {
    rebase(now);
    drift_ = drift;
  }
  /// Stands still until it goes on, as CLOCK_MONOTONIC does while a computer sleeps.
  void stop(base::Instant now) {
    rebase(now);
    is_stopped_ = true;
  }
  void go_on(base::Instant now) {
    rebase(now);
    is_stopped_ = false;
  }

 private:
  static constexpr std::int64_t millionths = 1'000'000;

  void rebase(base::Instant now) {
    local_ = local(now).time_since_epoch();
    world_ = now;
  }

  base::Duration local_;
  base::Instant world_{};
  std::int64_t drift_ = 0;
  bool is_stopped_ = false;
};

}  // namespace geminga::sim

#endif
