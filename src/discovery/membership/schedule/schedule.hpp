// The schedule of announcements: every interval, at once on a change and quickly again, never too often.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_SCHEDULE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_SCHEDULE_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/membership/schedule/token_bucket.hpp"

namespace geminga::membership {

/// The configuration of a schedule. Each time is argued in ANNOUNCEMENT.md, "When it is sent".
struct ScheduleOptions {
  /// The time between two announcements of an unchanged state, where few share the air.
  base::Duration interval = std::chrono::seconds(2);
};
/// The number of announcements that say a longer interval before it is kept: a receiver that has heard none of them
/// would expect the next one earlier.
inline constexpr int announced_before_slower = 6;

/// The interval is spread by this share in both directions, so that robots started together drift apart.
inline constexpr double interval_jitter = 0.1;
/// The times of further copies after the first copy of a change, which goes at once. The first few are of the state, as
/// many as the loss asks for (state_copies()). The others are presences: a receiver that has heard no state learns from
/// them that it lacks it.
inline constexpr std::array<base::Duration, 8> repeat_delays = {
    std::chrono::milliseconds(8),   std::chrono::milliseconds(20),  std::chrono::milliseconds(36),
    std::chrono::milliseconds(60),  std::chrono::milliseconds(120), std::chrono::milliseconds(220),
    std::chrono::milliseconds(400), std::chrono::milliseconds(700)};
/// The number of presences behind the copies of the state, but not more than those.
inline constexpr std::size_t presence_copies = 2;
/// The same while the loss is not known, as when a team starts.
inline constexpr std::size_t unknown_presence_copies = 4;
/// The times of further presences after a change if at least bad_loss is lost. One receiver in 500 misses all copies
/// above, and would learn of the change only by the next periodic presence.
inline constexpr std::array<base::Duration, 3> bad_presence_delays = {
    std::chrono::milliseconds(300), std::chrono::milliseconds(550), std::chrono::milliseconds(850)};
/// The times of further presences after a change where many share the air, as many as the interval is doubled: in a
/// large team somebody misses all copies above.
inline constexpr std::array<base::Duration, announcement::max_doublings> late_presence_delays = {
    std::chrono::milliseconds(1'200), std::chrono::seconds(2),          std::chrono::seconds(3),
    std::chrono::milliseconds(4'500), std::chrono::milliseconds(6'500), std::chrono::seconds(9),
    std::chrono::seconds(12),         std::chrono::seconds(15)};
/// The share by which each of these delays is spread in both directions.
inline constexpr double repeat_jitter = 0.2;
/// The number of copies of a changed state at this loss (ANNOUNCEMENT.md, "When it is sent"). Nothing: the loss is not
/// known.
[[nodiscard]] std::size_t state_copies(std::optional<double> loss);
/// The least time between two announcements. Changes within it are told together.
inline constexpr base::Duration min_spacing = std::chrono::milliseconds(3);
/// A change goes at once. Those that come within this time after it share the next datagram, and so on; while they go
/// on coming, the time doubles up to the longest one. So a client that says all that it has is not told state by state.
inline constexpr base::Duration change_spacing = std::chrono::milliseconds(20);
inline constexpr base::Duration longest_change_spacing = std::chrono::milliseconds(160);
/// The announcements that may go at min_spacing; after them one each refill_time. A peer that changes its services
/// without end costs the air at most 1 / refill_time announcements a second.
inline constexpr std::int64_t burst_capacity = 32;
inline constexpr base::Duration refill_time = std::chrono::milliseconds(50);

/// The longest of the random delays before a newcomer is answered, so that a team does not answer in one instant.
inline constexpr base::Duration max_newcomer_delay = std::chrono::milliseconds(20);
/// The times of further copies after the first copy for a newcomer, spread as above. Another list counts if at least
/// bad_loss is lost.
inline constexpr double bad_loss = 0.4;
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

/// The budget of repeats of the state for participants that say that they lack it, in datagrams of one link: so many at
/// once, then so many in an interval. One repeat answers all that ask within the delay.
inline constexpr std::int64_t repair_capacity = 32;
inline constexpr int repairs_per_interval = 2;
inline constexpr base::Duration max_repair_delay = std::chrono::milliseconds(10);
inline constexpr base::Duration repair_spacing = std::chrono::milliseconds(25);
/// The budget of presences while we lack the state of a participant or doubt that it lives: so many within ask_spacing
/// of each other, then so many in an interval. The first number gets through any loss. The second bounds what a
/// pretended participant can make us say.
inline constexpr std::int64_t ask_capacity = 40;
inline constexpr int asks_per_interval = 2;
inline constexpr base::Duration ask_spacing = std::chrono::milliseconds(100);
/// The spacing while we lack a state. It is shorter, since only its owner answers and not the whole team.
inline constexpr base::Duration lack_spacing = std::chrono::milliseconds(50);
inline constexpr base::Duration max_ask_delay = std::chrono::milliseconds(20);
/// The budget of presences for lost participants: enough for one search of half a team of ten, or for two searches of
/// the other nine (search.hpp).
inline constexpr std::int64_t search_capacity = 120;
inline constexpr int search_refill_intervals = 4;
/// The budget of signs of life for participants that doubt us, or doubt somebody that we hear. One answers all that
/// doubt within the spacing.
inline constexpr std::int64_t proof_capacity = 40;
inline constexpr int proofs_per_interval = 4;
inline constexpr base::Duration proof_spacing = std::chrono::milliseconds(30);
/// The budget of presences for participants that may not know us, or have heard nothing of us: so many at once, then
/// one in an interval, and none sooner than the spacing after anything else that we said. For doubtful_intervals after
/// a change it includes participants that say that they have not heard us, since they may not know the change.
inline constexpr int doubtful_intervals = 8;
inline constexpr std::int64_t differing_capacity = 24;
inline constexpr base::Duration differing_spacing = std::chrono::milliseconds(150);
/// The time that a witness leaves a doubted participant to answer for itself; at most twice that.
inline constexpr base::Duration witness_delay = std::chrono::milliseconds(25);
// Once a lie about us was heard, or a participant lacks our state, the state is said each time for contest_intervals: a
// contested participant must repeat everything (ANNOUNCEMENT.md, "A contradiction").

/// The budget of answers to claims of our identifier, one datagram on each link: all three claims of one claimant at
/// once, and under a forger's flood still one within the 90 ms of any claim.
inline constexpr std::int64_t contest_capacity = 4;
inline constexpr base::Duration contest_refill = std::chrono::milliseconds(60);
/// The budget of contradictions of lies about us, in datagrams of one link: so many at once, then so many in an
/// interval.
inline constexpr std::int64_t contradiction_capacity = 4;
inline constexpr int contradictions_per_interval = 4;

/// The number of goodbyes at the end, and the time between them.
inline constexpr std::size_t goodbye_copies = 3;
inline constexpr base::Duration goodbye_spacing = std::chrono::milliseconds(10);

/// One participant's schedule. Deterministic for its seed and its calls. It knows nothing of what is announced: take()
/// tells its caller what to announce on all interfaces.
class Schedule {
 public:
  /// `seed`: random bits for the jitter.
  Schedule(ScheduleOptions options, std::uint64_t seed);

  enum class Say : std::uint8_t {
    nothing,   ///< nothing is due
    state,     ///< the whole state
    change,    ///< the latest changes if they can be said alone, else the state
    presence,  ///< our presence: the revision of our state, and what we have heard of others
    goodbye,   ///< after stop()
  };

  /// Tells that the state changed. A copy of `what`, a change or the whole state, is due at once (or as soon as
  /// change_spacing and the limits allow), then the repeats. They are of the state while copies of the state are still
  /// to come. The first call starts the schedule; nothing is due before it.
  void changed(Say what, base::Instant now);
  /// Sets how many datagrams the whole state takes on one link, at least 1: the cost of an answer. It is 1 at first.
  void set_size(std::size_t datagrams);
  /// Sets how often the interval is doubled in what is said from now on, since many share the air. What all others do
  /// at the same time (answering newcomers, asking for somebody, witnessing) takes as many times longer.
  void set_doublings(std::uint8_t doublings, base::Instant now);
  /// Whether a longer interval is announced that is not kept yet.
  [[nodiscard]] bool is_slowing() const { return announced_until_slower_ > 0; }
  /// Tells that a participant is heard that does not know us yet (a newcomer, or a claimant). Copies follow as after
  /// changed(), but a little later, at most once in newcomer_spacing, and while the budget for answers lasts.
  void newcomer(base::Instant now);
  /// Sets the share of datagrams that is lost on the air, for the copies of later changes. It is unknown at first.
  void set_loss(std::optional<double> loss) { loss_ = loss; }
  /// Tells that a known participant lacks our state: a copy is due soon, while the budget lasts.
  void lacked(base::Instant now);
  /// Tells that a known participant seems to lack it, though it does not say so. Copies that are due anyway reach it.
  void seems_lacked(base::Instant now);
  /// Tells that a stranger, whose state we have not heard, lacks ours. A copy is due soon, of the budget for answers.
  void lacked_by_stranger(base::Instant now);
  /// Tells whether we lack a state, and whether we doubt that a participant lives (NeighbourTable). While one holds,
  /// our presence is due again and again. Each has its own budget, so that a forger of the one does not keep us from
  /// the other.
  void ask(bool lacks, bool doubts, base::Instant now);
  /// Tells whether our presence carries a challenge or an answer of sealing (sealing::Seal). While it does, our
  /// presence is due again and again, with a budget of its own, because a replay of others' challenges makes us say it.
  void challenge(bool is_open, base::Instant now);
  /// Tells that another participant doubts all that we doubt: the answers will reach us, too.
  void asked_by_another(base::Instant now);
  /// Tells that a participant knows others than we do, perhaps not us, or has not heard us since we changed. Our
  /// presence is due soon, so that it can say that it lacks our state.
  void differ(base::Instant now);
  /// Sets the search for lost participants: our presence is due so long after each of our announcements. Nothing: there
  /// is no search.
  void search(std::optional<base::Duration> spacing, base::Instant now);
  /// Tells that a participant doubts that we live: our presence is due.
  void doubted(base::Instant now);
  /// Tells that our next incarnation seems to begin, though we live: our presence is due again and again for a short
  /// while. Counts once in contest_intervals.
  void deny(base::Instant now);
  /// Tells that a participant doubts another one that we hear: our presence is due, a little later.
  /// Returns whether no testimony was due before.
  bool bear_witness(base::Instant now);
  /// Tells that it has given a sign of life itself: our testimony is not needed.
  void leave_testimony() { testimony_ = base::never; }
  /// Tells that our identifier is claimed (IdentifierClaim::Verdict::answer): our presence is due at once, or as soon
  /// as its budget allows, so that the claimant hears it before it holds the identifier.
  void contested(base::Instant now);
  /// Tells that a lie in our name was heard: one copy of the state is due at once, if its budget is not empty. Each
  /// periodic announcement of the next contest_intervals is the state, too.
  void contradict(base::Instant now);
  /// Stops the schedule until changed(): the identifier was lost, say.
  void pause();
  /// Ends the schedule: only goodbyes are due, the first at once, regardless of the limits.
  void stop(base::Instant now);

  /// When take() has something to send; base::never: nothing.
  [[nodiscard]] base::Instant due() const;
  /// The announcement that is due now. The schedule moves on. Call until it returns nothing.
  [[nodiscard]] Say take(base::Instant now);
  /// Whether stop() was called and all goodbyes have been taken.
  [[nodiscard]] bool is_finished() const;

 private:
  /// Something that our presence says until it is answered.
  struct Question {
    base::Instant due = base::never;
    TokenBucket budget;
    std::optional<base::Instant> asked{};  ///< when it was said last
  };
  /// One copy of a change.
  struct Copy {
    base::Instant due;
    Say what;
  };

  void plan(Question& question, bool is_open, base::Duration spacing, base::Instant now);
  /// When the first copy of a change is due.
  [[nodiscard]] base::Instant first_copy(base::Instant now);
  [[nodiscard]] base::Duration spread(base::Duration time, double share);
  [[nodiscard]] base::Duration said_interval() const { return announcement::stretched(options_.interval, doublings_); }
  /// A time that grows with the number of participants that share the air.
  [[nodiscard]] base::Duration slowed(base::Duration time) const { return time * (1 << doublings_); }
  /// When the state or the presence is wanted, for any reason, within its own budgets.
  [[nodiscard]] base::Instant state_wanted() const;
  [[nodiscard]] base::Instant presence_wanted() const;
  [[nodiscard]] base::Instant next_copy(Say what) const;
  [[nodiscard]] bool is_insistent() const { return periodic_ < insistent_until_; }
  [[nodiscard]] base::Instant allowed() const;
  [[nodiscard]] base::Instant spaced() const;
  /// Returns the state or a change if one is due, and pays for it. What was due until now counts as said.
  [[nodiscard]] Say take_state(base::Instant now);
  [[nodiscard]] bool take_presence(base::Instant now);
  void begin_answers(base::Instant now);
  /// Forgets the copies that are due, which what is said now replaces.
  void drop_copies(bool is_presence, base::Instant now);

  ScheduleOptions options_;
  base::Random random_;
  std::vector<Copy> copies_;                 ///< those of the last change that are still to come, in order of time
  std::optional<base::Instant> change_due_;  ///< the first copy of the last change
  bool is_change_pending_ = false;           ///< that was not said yet
  base::Duration change_wait_ = change_spacing;
  std::optional<double> loss_;
  std::uint8_t doublings_ = 0;
  base::Duration interval_;  ///< the interval that is kept; shorter than the announced one while that is new
  int announced_until_slower_ = 0;
  std::vector<base::Instant> answers_;  ///< copies for newcomers that are still to come, in order of time
  base::Instant periodic_ = base::never;
  base::Instant lacked_since_;          ///< when participants began to say that they lack the state
  base::Instant lacked_last_;           ///< when one said so last
  base::Instant insistent_until_;       ///< until then the state is announced each time
  base::Instant repair_ = base::never;  ///< when the state is due because another participant lacks it
  base::Instant search_ = base::never;  ///< when the presence is due for the search
  std::optional<base::Duration> search_spacing_;
  base::Instant proof_ = base::never;      ///< when a sign of life is due because we are doubted
  base::Instant testimony_ = base::never;  ///< when the presence is due because another participant is doubted
  base::Instant denial_ = base::never;     ///< when the next denial is due
  int denials_left_ = 0;
  std::optional<base::Instant> denied_;        ///< when the denials began last
  base::Instant contested_ = base::never;      ///< when a claim of our identifier came
  base::Instant contradiction_ = base::never;  ///< when a lie about us was heard
  base::Instant newcomer_due_ = base::never;   ///< when copies for newcomers begin
  base::Instant newcomer_last_;                ///< when they last began
  bool had_newcomer_ = false;
  base::Instant last_sent_;
  base::Instant state_sent_;
  bool has_sent_ = false;
  std::int64_t size_ = 1;
  TokenBucket announcements_{burst_capacity, refill_time};
  TokenBucket newcomers_;
  TokenBucket repairs_;
  Question lacks_;
  Question doubts_;
  Question challenges_;
  Question differs_;
  TokenBucket searches_;
  TokenBucket proofs_;
  TokenBucket contests_{contest_capacity, contest_refill};
  TokenBucket contradictions_;
  std::size_t goodbyes_left_ = 0;
  base::Instant goodbye_due_ = base::never;
  bool is_running_ = false;
  bool is_stopping_ = false;
};

}  // namespace geminga::membership

#endif
