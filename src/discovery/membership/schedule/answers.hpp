// The answers to newcomers: copies of the state a little after each other, within a budget.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_ANSWERS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_ANSWERS_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/time.hpp"
#include "discovery/membership/schedule/copies.hpp"
#include "discovery/membership/schedule/pace.hpp"
#include "discovery/membership/schedule/token_bucket.hpp"

namespace geminga::membership {

/// The longest of the random delays before a newcomer is answered, so that a team does not answer in one instant.
inline constexpr base::Duration max_newcomer_delay = std::chrono::milliseconds(20);
/// The times of further copies after the first copy for a newcomer, spread by repeat_jitter. Another list counts if at
/// least bad_loss is lost.
inline constexpr std::array<base::Duration, 1> answer_delays = {std::chrono::milliseconds(60)};
inline constexpr std::array<base::Duration, 3> bad_answer_delays = {
    std::chrono::milliseconds(30), std::chrono::milliseconds(60), std::chrono::milliseconds(120)};
/// The times of presences behind them. The second goes only if the loss is unknown or not small. They also show which
/// participants we know.
inline constexpr std::array<base::Duration, 2> answer_presence_delays = {std::chrono::milliseconds(120),
                                                                         std::chrono::milliseconds(400)};
/// The least time between two series of copies for newcomers. A newcomer within it is answered at its end, unless
/// copies that are due anyway reach it.
inline constexpr base::Duration newcomer_spacing = std::chrono::seconds(1);
/// The budget of answers to newcomers, in datagrams of one link: ten rounds of a small state at once, so that a team
/// that is switched on within ten seconds is answered, then one datagram in so many intervals. That is a quarter of
/// what a state in each interval would cost. A newcomer that finds the budget empty learns of us within one interval.
inline constexpr std::int64_t answer_capacity = 40;
inline constexpr int answer_refill_intervals = 4;

/// The copies of the state that participants need who do not know us yet.
class Answers {
 public:
  /// `interval`: the configured one.
  explicit Answers(base::Duration interval) : budget_(answer_capacity, answer_refill_intervals * interval) {}

  /// Tells of a newcomer. Its copies begin a little later, unless those in `copies` reach it as well.
  void newcomer(const Copies& copies, Pace& pace, base::Instant now);
  /// Tells that a stranger lacks our state, and may hear it from `earliest` on. One copy is due soon, while the budget
  /// lasts.
  void lacked_by_stranger(base::Instant earliest, Pace& pace, base::Instant now);
  /// When a copy is due, or the copies for a newcomer begin.
  [[nodiscard]] base::Instant due() const;
  /// Begins the copies for a newcomer if that is due, the presences behind them in `copies`.
  void begin_due(Copies& copies, std::optional<double> loss, Pace& pace, base::Instant now);
  /// Forgets the copies that are due. Returns the budget that pays for them; null: none is due, or it is empty.
  [[nodiscard]] TokenBucket* take_due(base::Instant now);
  /// Forgets all copies that are to come.
  void clear();

 private:
  std::vector<base::Instant> copies_;            ///< those that are still to come, in order of time
  base::Instant newcomer_due_ = base::never;     ///< when copies for newcomers begin
  std::optional<base::Instant> newcomer_begun_;  ///< when they last began
  TokenBucket budget_;
};

}  // namespace geminga::membership

#endif
