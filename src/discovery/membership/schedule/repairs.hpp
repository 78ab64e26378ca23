// The state said again: for participants that lack it, and against lies about it.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_REPAIRS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_REPAIRS_HPP

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/time.hpp"
#include "discovery/membership/schedule/occasion.hpp"
#include "discovery/membership/schedule/pace.hpp"
#include "discovery/membership/schedule/token_bucket.hpp"

namespace geminga::membership {

/// The budget of repeats of the state for participants that say that they lack it, in datagrams of one link: so many at
/// once, then so many in an interval. One repeat answers all that ask within the delay.
inline constexpr std::int64_t repair_capacity = 32;
inline constexpr int repairs_per_interval = 2;
inline constexpr base::Duration max_repair_delay = std::chrono::milliseconds(10);
inline constexpr base::Duration repair_spacing = std::chrono::milliseconds(25);
/// The budget of contradictions of lies about us, in datagrams of one link: so many at once, then so many in an
/// interval.
inline constexpr std::int64_t contradiction_capacity = 4;
inline constexpr int contradictions_per_interval = 4;

/// The repeats of the state that known participants need. Once a lie about us was heard, or a participant lacks our
/// state, the state is said each time for contest_intervals: a contested participant must repeat everything
/// (ANNOUNCEMENT.md, "A contradiction").
class Repairs {
 public:
  /// `interval`: the configured one.
  explicit Repairs(base::Duration interval)
      : repair_{{repair_capacity, interval / repairs_per_interval}},
        contradiction_{{contradiction_capacity, interval / contradictions_per_interval}} {}

  /// Tells that a known participant lacks our state, and may hear it from `earliest` on. A copy is due soon, while the
  /// budget lasts.
  void lacked(base::Instant earliest, Pace& pace, base::Instant now);
  /// Tells that a lie in our name was heard: the state is to be said each time.
  void insist(const Pace& pace, base::Instant now);
  /// One copy of the state is due at once, if its budget is not empty.
  void contradict(base::Instant now);
  /// Whether an announcement of that instant is to be the state.
  [[nodiscard]] bool is_insistent(base::Instant due) const { return due < insistent_until_; }
  /// When a copy is due.
  [[nodiscard]] base::Instant due() const { return std::min(repair_.due, contradiction_.due); }
  /// Forgets what is due. Returns the budget that pays for it; null: nothing is due, or it is empty.
  [[nodiscard]] TokenBucket* take_due(base::Instant now);
  /// Forgets all copies that are to come.
  void clear() { repair_.due = contradiction_.due = base::never; }

 private:
  std::optional<base::Instant> lacked_since_;  ///< when participants began to say that they lack the state
  std::optional<base::Instant> lacked_last_;   ///< when one said so last
  base::Instant insistent_until_;              ///< until then the state is announced each time
  Occasion repair_;                            ///< another participant lacks the state
  Occasion contradiction_;                     ///< a lie about us was heard
};

}  // namespace geminga::membership

#endif
