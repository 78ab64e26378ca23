// The signs of life of a participant, heard by us or by others, and the deadline that follows from them.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LIFE_SIGNS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LIFE_SIGNS_HPP

#include <algorithm>
#include <optional>

#include "base/time.hpp"
#include "discovery/membership/schedule/deadline.hpp"

namespace geminga::membership {

/// Keeps to ANNOUNCEMENT.md, "Deadlines". Each call is told the interval that counts, and how well it is received.
class LifeSigns {
 public:
  LifeSigns(base::Instant now, base::Duration interval) : heard_(now), deadline_(now + patience(interval, {})) {}

  /// Takes in that we have heard it ourselves, or that a relay did at that instant.
  void hear(base::Instant at) { heard_ = std::max(heard_, at); }
  /// Sets the deadline by the last sign of life. Ends the doubt.
  void renew(base::Duration interval, const Reception& reception);
  /// Takes in that others have heard it at `seen` or later. Returns whether the deadline has moved. All of them
  /// together move it by one deadline at most, from that which our own last word of it has set.
  bool witness(base::Instant seen, base::Instant now, base::Duration interval, const Reception& reception);
  /// Takes in that its next incarnation seems to have begun: it is doubted, and once it was asked its deadline is near.
  /// Counts once in contest_intervals.
  void succeed(base::Instant now, base::Duration interval);
  /// Takes in that it is asked for a sign of life. `patience`: how long the answer may take if its next incarnation
  /// seems to have begun.
  void ask(base::Instant now, base::Duration patience);
  [[nodiscard]] std::optional<base::Instant> succeeded() const { return succeeded_; }
  void set_succeeded(std::optional<base::Instant> succeeded) { succeeded_ = succeeded; }
  /// Begins the doubt if it is due. Call at doubt_due(), or later.
  void doubt(base::Instant now, base::Duration interval) { is_doubted_ |= doubt_due(interval) <= now; }
  /// Begins the doubt at once: somebody else doubts it who hears it through us.
  void doubt() { is_doubted_ = true; }
  /// Makes the deadline at most `latest`, or at least `earliest`.
  void shorten(base::Instant latest) { deadline_ = std::min(deadline_, latest); }
  void postpone(base::Instant earliest) { deadline_ = std::max(deadline_, earliest); }

  [[nodiscard]] base::Instant heard() const { return heard_; }
  [[nodiscard]] base::Instant deadline() const { return deadline_; }
  /// When the doubt begins.
  [[nodiscard]] base::Instant doubt_due(base::Duration interval) const;
  /// Whether it gave no sign of life for so long that its deadline is near.
  [[nodiscard]] bool is_doubted() const { return is_doubted_; }

 private:
  [[nodiscard]] base::Instant seen() const { return std::max(heard_, witnessed_); }
  /// The latest deadline that witnesses can bring about.
  [[nodiscard]] base::Instant latest(base::Duration interval, const Reception& reception) const {
    return heard_ + patience(interval, reception) + witnessed_time(interval, reception.loss);
  }

  base::Instant heard_;
  base::Instant witnessed_;  ///< when others have heard it, as far as we know
  base::Instant deadline_;
  base::Instant latest_ = base::never;  ///< the deadline that witnesses cannot move, as it was last known
  base::Duration delay_{};              ///< by which signs of life are late (Reception)
  bool is_doubted_ = false;
  std::optional<base::Instant> succeeded_;  ///< when its next incarnation seemed to begin
  bool is_unasked_ = false;                 ///< its next incarnation seems to have begun, and it was not asked yet
};

}  // namespace geminga::membership

#endif
