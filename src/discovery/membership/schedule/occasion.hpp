// A reason to say something, and the budget that pays for it.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_OCCASION_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_OCCASION_HPP

#include <algorithm>

#include "base/time.hpp"
#include "discovery/membership/schedule/token_bucket.hpp"

namespace geminga::membership {

/// A reason to send an announcement at one instant, with a budget of its own.
struct Occasion {
  TokenBucket budget;
  base::Instant due = base::never;

  /// The instant at which it is due and its budget has a token; base::never: it is not due.
  [[nodiscard]] base::Instant affordable() const {
    return due == base::never ? base::never : std::max(due, budget.due());
  }
  /// Pays for one announcement if the budget has a token.
  void pay(base::Instant now) {
    if (budget.has(now)) budget.take(now);
  }
};

}  // namespace geminga::membership

#endif
