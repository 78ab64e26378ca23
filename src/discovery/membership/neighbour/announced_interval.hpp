// The interval that a participant announces, and how far that is trusted.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ANNOUNCED_INTERVAL_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ANNOUNCED_INTERVAL_HPP

#include <algorithm>
#include <optional>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/membership/neighbour/revocable.hpp"

namespace geminga::membership {

/// Deadlines follow from the interval, so no single datagram makes them shorter or longer. A shorter one counts after
/// two old intervals. A longer one counts when it was said, at the old pace, for an old interval, and then as twice the
/// old one at most: a sender that is about to slow down keeps the old pace for six announcements.
class AnnouncedInterval {
 public:
  AnnouncedInterval(base::Duration interval, base::Instant now) : interval_(interval, now), believed_(interval) {}

  /// The interval that was announced last.
  [[nodiscard]] base::Duration value() const { return interval_.value(); }
  /// The interval that deadlines use. The time for which a former interval counts is measured in itself: a forged one
  /// can neither outlast nor outrun it.
  [[nodiscard]] base::Duration lasting(base::Instant now) const {
    if (value() >= believed_) return believed_;
    return interval_.former(now, announcement::hold_intervals * believed_) != nullptr ? believed_ : value();
  }

  /// Takes in an announced interval. One that differs from the present one is taken unless the participant is contested
  /// and the present one is held.
  void say(base::Duration interval, base::Instant now, base::Duration hold, bool is_contested) {
    believed_ = lasting(now);
    if (interval == value()) {
      interval_.affirm(now);
    } else if (!is_contested || !interval_.is_held(now, hold)) {
      interval_.replace(interval, now, hold);
      longer_since_.reset();
    }
    if (value() > believed_) grow(now);
  }
  /// Undoes what was said less than `hold` ago.
  void roll_back(base::Instant now, base::Duration hold) {
    interval_.roll_back(now, hold);
    longer_since_.reset();
  }

 private:
  /// The jitter of an interval, and a little for the air.
  static constexpr int nearly_percent = 80;

  void grow(base::Instant now) {
    // Words of the old pace never leave out its longest deadline.
    const bool goes_on = longer_since_ && now - longer_said_ < announcement::contest_intervals * believed_;
    longer_said_ = now;
    if (!goes_on) {
      longer_since_ = now;
    } else if (now - *longer_since_ >= believed_ * nearly_percent / 100) {
      believed_ = std::min(value(), 2 * believed_);
      longer_since_ = now;
    }
  }

  Revocable<base::Duration> interval_;
  base::Duration believed_;
  std::optional<base::Instant> longer_since_;  ///< since when a longer one than the believed one is said
  base::Instant longer_said_;
};

}  // namespace geminga::membership

#endif
