// When the next announcement is due: every interval, at once on a change and quickly again, never too often.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_HPP

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/random.hpp"
#include "base/time.hpp"
#include "discovery/membership/token_bucket.hpp"

namespace geminga::membership {

/// What the schedule keeps to. Each time is argued in ANNOUNCEMENT.md, "When it is sent".
struct ScheduleOptions {
  /// The time between two announcements of an unchanged state.
  base::Duration interval = std::chrono::seconds(2);
};

/// The interval is spread by this share in both directions, so that robots started together drift apart.
inline constexpr double interval_jitter = 0.1;
/// After the first copy of a change, which goes at once, further ones follow so long after it: with five copies 99.8 %
/// of changes arrive at 30 % loss.
inline constexpr std::array<base::Duration, 4> repeat_delays = {
    std::chrono::milliseconds(20), std::chrono::milliseconds(60), std::chrono::milliseconds(140),
    std::chrono::milliseconds(300)};
/// Each of them is spread by this share in both directions.
inline constexpr double repeat_jitter = 0.2;
/// Never two announcements within this time. Changes within it are told together.
inline constexpr base::Duration min_spacing = std::chrono::milliseconds(3);
/// So many announcements may go at min_spacing; then only one each refill_time: a peer that changes its services
/// without end costs the air at most 1 / refill_time announcements a second.
inline constexpr std::int64_t burst_capacity = 16;
inline constexpr base::Duration refill_time = std::chrono::milliseconds(50);

/// A newcomer is answered after a random time up to this, so that a team does not answer in one instant.
inline constexpr base::Duration max_newcomer_delay = std::chrono::milliseconds(20);
/// After the first copy for a newcomer further ones follow so long after it, spread as above.
inline constexpr std::array<base::Duration, 2> answer_delays = {std::chrono::milliseconds(60),
                                                                std::chrono::milliseconds(200)};
/// Newcomers start copies at most once in this time; one that comes within it is answered at its end, unless copies
/// that are due anyway reach it.
inline constexpr base::Duration newcomer_spacing = std::chrono::seconds(1);
/// What answers to newcomers may cost, in datagrams of one link: ten rounds of a small state at once, so that a team
/// that is switched on within ten seconds is answered, and then one datagram in so many intervals, which is a quarter
/// of what the periodic announcements cost. A newcomer that finds it used up learns of us within one interval.
inline constexpr std::int64_t answer_capacity = 32;
inline constexpr int answer_refill_intervals = 4;

/// Answers to claims of our identifier, one datagram on each link: all three of one claimant at once, and with a forger
/// still one within the 90 ms of any claim.
inline constexpr std::int64_t contest_capacity = 4;
inline constexpr base::Duration contest_refill = std::chrono::milliseconds(60);
/// What contradicting others' lies about us may cost, in datagrams of one link: so many at once, then so many in an
/// interval.
inline constexpr std::int64_t contradiction_capacity = 4;
inline constexpr int contradictions_per_interval = 4;

/// Goodbyes at the end, and the time between them.
inline constexpr std::size_t goodbye_copies = 3;
inline constexpr base::Duration goodbye_spacing = std::chrono::milliseconds(10);

/// One participant's schedule. Deterministic for its seed and its calls. It knows nothing of what is announced; take()
/// says what the caller announces on all interfaces.
class Schedule {
 public:
  /// `seed`: random bits for the jitter.
  Schedule(ScheduleOptions options, std::uint64_t seed);

  /// The state changed, or was claimed for: a copy is due at once (or as soon as the limits allow), then the repeats.
  /// Begins the schedule; before the first call nothing is due.
  void changed(base::Instant now);
  /// How many datagrams the whole state takes on one link, at least 1: what an answer costs. 1 until told.
  void set_size(std::size_t datagrams);
  /// A participant is heard that does not know us yet (a newcomer, or a claimant): as changed(), but a little later,
  /// not more often than newcomer_spacing, and only as long as the budget for answers lasts.
  void newcomer(base::Instant now);
  /// Somebody claims our identifier (IdentifierClaim::Verdict::answer): our presence is due at once, or as soon as the
  /// budget for it allows, so that a claimant hears it before it holds the identifier.
  void contested(base::Instant now);
  /// Somebody said in our name what we have not said: one copy of the state is due at once, if the budget for it is not
  /// used up; if it is, the periodic announcement is the contradiction.
  void contradict(base::Instant now);
  /// Nothing is due any more until changed(): the identifier was lost, say.
  void pause();
  /// Only goodbyes are due from now on, the first at once, regardless of the limits.
  void stop(base::Instant now);

  enum class Say : std::uint8_t {
    nothing,   ///< nothing is due
    state,     ///< the whole state
    presence,  ///< one datagram of the state: it shows whose the identifier is
    goodbye,   ///< after stop()
  };
  /// When take() is to be asked, or base::never.
  [[nodiscard]] base::Instant due() const;
  /// What is to be sent now; the schedule moves on. Ask until it says nothing.
  [[nodiscard]] Say take(base::Instant now);
  /// Whether stop() was called and all goodbyes have been taken.
  [[nodiscard]] bool is_finished() const;

 private:
  static constexpr std::size_t change_copies = repeat_delays.size() + 1;
  static constexpr std::size_t answer_copies = answer_delays.size() + 1;

  [[nodiscard]] base::Duration spread(base::Duration time, double share);
  /// When the whole state is wanted, for whatever reason, and when the limits allow it.
  [[nodiscard]] base::Instant wanted() const;
  [[nodiscard]] base::Instant allowed() const;
  [[nodiscard]] base::Instant spaced() const;
  /// Whether the state is due; pays for it, and what was due until now counts as told.
  [[nodiscard]] bool take_state(base::Instant now);

  ScheduleOptions options_;
  base::Random random_;
  std::array<base::Instant, change_copies> copies_{};  ///< of the last change
  std::size_t next_copy_ = change_copies;
  std::array<base::Instant, answer_copies> answers_{};  ///< the copies for newcomers
  std::size_t next_answer_ = answer_copies;
  base::Instant periodic_ = base::never;
  base::Instant contested_ = base::never;      ///< when a claim to our identifier came
  base::Instant contradiction_ = base::never;  ///< when a lie about us was heard
  base::Instant newcomer_due_ = base::never;   ///< when the copies for newcomers begin
  base::Instant newcomer_last_;                ///< when they last began
  bool had_newcomer_ = false;
  base::Instant last_sent_;
  bool has_sent_ = false;
  std::int64_t size_ = 1;
  TokenBucket announcements_{burst_capacity, refill_time};
  TokenBucket newcomers_;
  TokenBucket contests_{contest_capacity, contest_refill};
  TokenBucket contradictions_;
  std::size_t goodbyes_left_ = 0;
  base::Instant goodbye_due_ = base::never;
  bool is_running_ = false;
  bool is_stopping_ = false;
};

}  // namespace geminga::membership

#endif
