// How long after its last sign of life a participant is taken for gone. ANNOUNCEMENT.md, "Deadlines", has the
// arithmetic.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_DEADLINE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_DEADLINE_HPP

#include <cstddef>

#include "base/time.hpp"

namespace geminga::membership {

/// What is known of the air between somebody and us.
struct Reception {
  double loss = 0;            ///< the share of its datagrams that we miss, in [0, 1]
  std::size_t witnesses = 0;  ///< how often others said in an interval how lately they have heard it
};

/// Intervals without a sign of life after which a participant is gone: where nothing is lost, and at most.
inline constexpr double shortest_deadline = 2.25;
inline constexpr double longest_deadline = 5;
/// Somebody who has given no sign of life for so many intervals is asked for one until its deadline.
inline constexpr double doubt_after = 1.9;
/// So many others tell us enough of somebody whom we do not hear ourselves.
inline constexpr std::size_t enough_witnesses = 3;
/// The word of others counts no longer than for so many intervals in which we have heard nothing ourselves.
inline constexpr int witnessed_intervals = 32;
/// What a participant announced counts for so many intervals after it was last said, while its newest state has not
/// been heard.
inline constexpr int service_intervals = 5;

/// The share of living participants that may not be heard in time when their next life seems to have begun.
inline constexpr double wrong_successions = 1e-3;
/// Who hears that somebody begins its own life anew denies it so often, in this time. So many are awaited at least, and
/// so many more may be missing since he heard of it later than others.
inline constexpr int denials = 20;
inline constexpr int denials_awaited = 7;
inline constexpr int denials_unprompted = 2;
inline constexpr base::Duration denial_spacing = std::chrono::milliseconds(15);
/// Time for one question and its answer, and the least that anybody is given: all denials, and how late the last may
/// come.
inline constexpr base::Duration question_time = std::chrono::milliseconds(100);
inline constexpr base::Duration least_answer_time = std::chrono::milliseconds(120);
static_assert(least_answer_time >= denials_awaited * denial_spacing);
/// So many questions fit between the first doubt and the deadline, however short the interval is.
inline constexpr int least_questions = 3;

/// For how long somebody is asked for a sign of life whose next life seems to have begun.
[[nodiscard]] base::Duration answer_time(double loss);
/// For how long a sign of life counts.
[[nodiscard]] base::Duration patience(base::Duration interval, const Reception& reception);
/// When a sign of life at `seen` has counted for so many intervals.
[[nodiscard]] base::Instant after_intervals(base::Instant seen, base::Duration interval, double intervals);

}  // namespace geminga::membership

#endif
