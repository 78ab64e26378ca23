// When somebody was last heard, by us or by others, and until when that counts.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_LIFE_SIGNS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_LIFE_SIGNS_HPP

#include <algorithm>
#include <optional>

#include "base/time.hpp"
#include "discovery/membership/deadline.hpp"

namespace geminga::membership {

/// The signs of life of one participant, and the deadline that follows from them (ANNOUNCEMENT.md, "Deadlines"). Each
/// call is told the interval that counts and how well it is received.
class LifeSigns {
 public:
  LifeSigns(base::Instant now, base::Duration interval) : heard_(now), deadline_(now + patience(interval, {})) {}

  /// We have heard it ourselves.
  void hear(base::Instant now) { heard_ = now; }
  /// The deadline follows from the last sign of life; nobody doubts any more.
  void renew(base::Duration interval, const Reception& reception);
  /// Others have heard it at `seen` or later; whether the deadline has moved.
  bool witness(base::Instant seen, base::Instant now, base::Duration interval, const Reception& reception);
  /// Its next life seems to have begun: it is doubted, and its deadline is near once it was asked. Once in
  /// contest_intervals.
  void succeed(base::Instant now, base::Duration interval);
  /// It is asked for a sign of life. `patience`: how long the answer may take where its next life seems to have begun.
  void ask(base::Instant now, base::Duration patience);
  [[nodiscard]] std::optional<base::Instant> succeeded() const { return succeeded_; }
  void set_succeeded(std::optional<base::Instant> succeeded) { succeeded_ = succeeded; }
  /// To be called at doubt_due(), or later.
  void doubt(base::Instant now, base::Duration interval) { is_doubted_ |= doubt_due(interval) <= now; }
  /// No deadline is later, or earlier, than this.
  void shorten(base::Instant latest) { deadline_ = std::min(deadline_, latest); }
  void postpone(base::Instant earliest) { deadline_ = std::max(deadline_, earliest); }

  [[nodiscard]] base::Instant heard() const { return heard_; }
  [[nodiscard]] base::Instant deadline() const { return deadline_; }
  /// When the question for a sign of life begins.
  [[nodiscard]] base::Instant doubt_due(base::Duration interval) const;
  /// Whether it gives no sign of life, and its deadline is near.
  [[nodiscard]] bool is_doubted() const { return is_doubted_; }

 private:
  [[nodiscard]] base::Instant seen() const { return std::max(heard_, witnessed_); }

  base::Instant heard_;
  base::Instant witnessed_;  ///< when others have heard it, for what we know
  base::Instant deadline_;
  bool is_doubted_ = false;
  std::optional<base::Instant> succeeded_;  ///< when its next life seemed to begin
  bool is_unasked_ = false;                 ///< its next life seems to have begun, and it was not asked yet
};

}  // namespace geminga::membership

#endif
