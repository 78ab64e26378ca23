// The interval that a participant announces, and how far that is trusted.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ANNOUNCED_INTERVAL_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ANNOUNCED_INTERVAL_HPP

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/membership/neighbour/revocable.hpp"

namespace geminga::membership {

/// Deadlines follow from the interval, so no single datagram makes them shorter or longer.
class AnnouncedInterval {
 public:
  AnnouncedInterval(base::Duration interval, base::Instant now) : interval_(interval, now) {}

  /// The interval that was announced last.
  [[nodiscard]] base::Duration value() const { return interval_.value(); }
  /// The interval from before the last `hold_intervals`. The time for which a former interval counts is measured in
  /// itself: a forged one can neither outlast nor outrun it.
  [[nodiscard]] base::Duration settled(base::Instant now) const {
    const auto* former = interval_.former(now, announcement::hold_intervals * announcement::max_interval);
    const bool counts = former != nullptr && interval_.former(now, announcement::hold_intervals * *former) != nullptr;
    return counts ? *former : value();
  }
  /// The interval that deadlines use: a shorter one counts when it is settled, a longer one when it was said twice.
  [[nodiscard]] base::Duration lasting(base::Instant now) const {
    const auto before = settled(now);
    return value() > before && interval_.is_repeated() ? value() : before;
  }

  /// Takes in an announced interval. One that differs from the present one is taken unless the participant is contested
  /// and the present one is held.
  void say(base::Duration interval, base::Instant now, base::Duration hold, bool is_contested) {
    if (interval == value()) {
      interval_.affirm(now);
    } else if (!is_contested || !interval_.is_held(now, hold)) {
      interval_.replace(interval, now, hold);
    }
  }
  /// Undoes what was said less than `hold` ago.
  void roll_back(base::Instant now, base::Duration hold) { interval_.roll_back(now, hold); }

 private:
  Revocable<base::Duration> interval_;
};

}  // namespace geminga::membership

#endif
