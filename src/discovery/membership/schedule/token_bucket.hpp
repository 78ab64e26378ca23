// A budget that fills up with time: so much at once, then so much per time.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_TOKEN_BUCKET_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_TOKEN_BUCKET_HPP

#include <algorithm>
#include <cstdint>

#include "base/time.hpp"

namespace geminga::membership {

/// Holds at most `capacity` tokens, all of them at first, and gets one back every `refill_time`. A cost above the
/// level is lent, so that now and then a cost that is too large for the bucket can be paid. The debt is at most
/// `capacity`, so that the wait for the next token is no longer than an empty bucket takes to fill.
class TokenBucket {
 public:
  /// Requires capacity > 0 and refill_time > 0.
  TokenBucket(std::int64_t capacity, base::Duration refill_time)
      : capacity_(capacity), refill_time_(refill_time), level_(capacity) {}

  /// Whether the bucket holds a token at `now`.
  [[nodiscard]] bool has(base::Instant now) const { return due() <= now; }
  /// When has() will hold; a past instant if it does.
  [[nodiscard]] base::Instant due() const {
    return level_ > 0 ? base::Instant::min() : filled_ + (1 - level_) * refill_time_;
  }
  /// Takes `cost` tokens. Requires has().
  void take(base::Instant now, std::int64_t cost = 1) {
    refill(now);
    level_ = std::max(level_ - cost, -capacity_);
  }

 private:
  void refill(base::Instant now) {
    if (level_ == capacity_) filled_ = now;
    const std::int64_t gained = std::min((now - filled_) / refill_time_, 2 * capacity_);
    level_ = std::min(level_ + gained, capacity_);
    filled_ = level_ == capacity_ ? now : filled_ + gained * refill_time_;
  }

  std::int64_t capacity_;
  base::Duration refill_time_;
  std::int64_t level_;
  base::Instant filled_{};  ///< when the last token came back
};

}  // namespace geminga::membership

#endif
