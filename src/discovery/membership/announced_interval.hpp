// The interval that a participant says it keeps, and how far that word is trusted.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_ANNOUNCED_INTERVAL_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_ANNOUNCED_INTERVAL_HPP

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/membership/settled.hpp"

namespace geminga::membership {

/// Deadlines are made of it, so no single word makes them shorter or longer.
class AnnouncedInterval {
 public:
  AnnouncedInterval(base::Duration interval, base::Instant now) : interval_(interval, now) {}

  /// As it was said last.
  [[nodiscard]] base::Duration value() const { return interval_.value(); }
  /// As it was before the last `hold_intervals` of it. How long a former one counts is reckoned in itself: a forged one
  /// cannot outlast or outrun it.
  [[nodiscard]] base::Duration settled(base::Instant now) const {
    const auto* former = interval_.former(now, announcement::hold_intervals * announcement::max_interval);
    const bool counts = former != nullptr && interval_.former(now, announcement::hold_intervals * *former) != nullptr;
    return counts ? *former : value();
  }
  /// A shorter one counts when it is settled, a longer one when it was said twice.
  [[nodiscard]] base::Duration lasting(base::Instant now) const {
    const auto before = settled(now);
    return value() > before && interval_.is_repeated() ? value() : before;
  }

  /// It is said. Another one than before is taken unless somebody lies in its name and the present one is held.
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
  Settled<base::Duration> interval_;
};

}  // namespace geminga::membership

#endif
