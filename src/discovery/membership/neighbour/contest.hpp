// The contest about a participant: somebody has lied in its name, and nobody can say which datagrams were true.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_CONTEST_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_CONTEST_HPP

#include <algorithm>

#include "base/time.hpp"

namespace geminga::membership {

/// Lasts until everything has fitted for a time, which each contradiction begins anew. While it lasts, services that
/// nobody repeats lapse.
class Contest {
 public:
  [[nodiscard]] bool is_open() const { return is_open_; }
  /// When its first contradiction was heard; requires that it is open.
  [[nodiscard]] base::Instant since() const { return since_; }

  /// A contradiction was heard: it lasts until `until`. Whether it has begun with that.
  bool begin(base::Instant now, base::Instant until) {
    until_ = until;
    if (is_open_) return false;
    is_open_ = true;
    since_ = now;
    next_lapse_ = now;
    return true;
  }
  /// It does not end before `until`.
  void prolong(base::Instant until) { until_ = std::max(until_, until); }
  /// Ends it where its time is over; whether it did.
  bool end(base::Instant now) {
    if (!is_open_ || now < until_) return false;
    is_open_ = false;
    return true;
  }

  /// Whether a service may lapse now.
  [[nodiscard]] bool is_lapse_due(base::Instant now) const { return is_open_ && next_lapse_ <= now; }
  /// The first instant at which another service may lapse.
  void set_next_lapse(base::Instant instant) { next_lapse_ = instant; }
  /// When it ends, or a service may lapse; `base::never` where there is none.
  [[nodiscard]] base::Instant next_deadline() const { return is_open_ ? std::min(until_, next_lapse_) : base::never; }

 private:
  bool is_open_ = false;
  base::Instant since_{};
  base::Instant until_{};
  base::Instant next_lapse_{};
};

}  // namespace geminga::membership

#endif
