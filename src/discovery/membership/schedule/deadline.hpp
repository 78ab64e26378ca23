// The time after its last sign of life at which a participant is taken for gone. ANNOUNCEMENT.md, "Deadlines", has the
// arithmetic.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_DEADLINE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_DEADLINE_HPP

#include <cstddef>

#include "base/time.hpp"

namespace geminga::membership {

/// The reception of a participant: what is known of the air between it and us.
struct Reception {
  double loss = 0;            ///< the share of its datagrams that we miss, in [0, 1]
  std::size_t witnesses = 0;  ///< how often others testified in an interval how lately they have heard it
  base::Duration delay{};     ///< by which its signs of life are late: an interval for each relay on the way
};

/// The shortest and the longest deadline, in intervals: the shortest where nothing is lost.
inline constexpr double shortest_deadline = 2.25;
inline constexpr double longest_deadline = 5;
/// A participant without a sign of life for so many intervals is asked for one until its deadline.
inline constexpr double doubt_after = 1.9;
/// So many witnesses tell us enough of a participant that we do not hear ourselves.
inline constexpr std::size_t enough_witnesses = 3;
/// A participant that we do not hear ourselves, though others do, is asked for a sign of life so many intervals before
/// testimony ends.
inline constexpr double asked_before_latest = 1.5;
/// A service counts for so many intervals after it was last announced, while the newest state was not heard.
inline constexpr int service_intervals = 5;

/// The share of living participants that may be taken for gone by mistake when their next incarnation seems to begin.
inline constexpr double wrong_successions = 1e-3;
/// A participant that hears of its own next incarnation denies it by so many presences, in this spacing. At least
/// `denials_awaited` are awaited, and `denials_unprompted` more may be missing because it heard of the incarnation
/// later than others.
inline constexpr int denials = 20;
inline constexpr int denials_awaited = 7;
inline constexpr int denials_unprompted = 2;
inline constexpr base::Duration denial_spacing = std::chrono::milliseconds(15);
/// The time for one question and its answer, and the least time that anybody is given: all awaited denials, and the
/// delay of the last.
inline constexpr base::Duration question_time = std::chrono::milliseconds(100);
inline constexpr base::Duration least_answer_time = std::chrono::milliseconds(120);
static_assert(least_answer_time >= denials_awaited * denial_spacing);
/// The least number of questions between the first doubt and the deadline, however short the interval is.
inline constexpr int least_questions = 3;

/// The time for which a participant is asked for a sign of life when its next incarnation seems to have begun.
[[nodiscard]] base::Duration answer_time(double loss);
/// The time for which a sign of life counts.
[[nodiscard]] base::Duration patience(base::Duration interval, const Reception& reception);
/// The time by which all testimony together moves a deadline at most: that of one more deadline.
[[nodiscard]] base::Duration witnessed_time(base::Duration interval, double loss);
/// When a sign of life at `seen` has counted for so many intervals.
[[nodiscard]] base::Instant after_intervals(base::Instant seen, base::Duration interval, double intervals);

}  // namespace geminga::membership

#endif
