// When the next announcement is due: every interval, at once on a change and quickly again, never too often.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/membership/token_bucket.hpp"

namespace geminga::membership {

/// What the schedule keeps to. Each time is argued in ANNOUNCEMENT.md, "When it is sent".
struct ScheduleOptions {
  /// The time between two announcements of an unchanged state, where few share the air.
  base::Duration interval = std::chrono::seconds(2);
};
/// A longer interval is kept only after so many announcements have said so: who has heard none of them would expect the
/// next one earlier.
inline constexpr int announced_before_slower = 6;

/// The interval is spread by this share in both directions, so that robots started together drift apart.
inline constexpr double interval_jitter = 0.1;
/// After the first copy of a change, which goes at once, further ones follow so long after it. The first few are of the
/// state, as many as the loss asks for (state_copies()); the others of the presence, from which whoever has heard none
/// of those learns that it lacks the state.
inline constexpr std::array<base::Duration, 8> repeat_delays = {
    std::chrono::milliseconds(8),   std::chrono::milliseconds(20),  std::chrono::milliseconds(36),
    std::chrono::milliseconds(60),  std::chrono::milliseconds(120), std::chrono::milliseconds(220),
    std::chrono::milliseconds(400), std::chrono::milliseconds(700)};
/// Copies of the presence behind those of the state, but not more than those.
inline constexpr std::size_t presence_copies = 2;
/// While the loss is not known, as when a team starts.
inline constexpr std::size_t unknown_presence_copies = 4;
/// Where at least bad_loss is lost, one receiver in 500 misses all of these, and would learn of the change by the next
/// presence: so many presences more, between and behind them, so long after the change.
inline constexpr std::array<base::Duration, 3> bad_presence_delays = {
    std::chrono::milliseconds(300), std::chrono::milliseconds(550), std::chrono::milliseconds(850)};
/// Where many share the air, somebody of them misses all of these: so many presences more as the interval is doubled.
inline constexpr std::array<base::Duration, announcement::max_doublings> late_presence_delays = {
    std::chrono::milliseconds(1'200), std::chrono::seconds(2),          std::chrono::seconds(3),
    std::chrono::milliseconds(4'500), std::chrono::milliseconds(6'500), std::chrono::seconds(9),
    std::chrono::seconds(12),         std::chrono::seconds(15)};
/// Each of these delays is spread by this share in both directions.
inline constexpr double repeat_jitter = 0.2;
/// How often a changed state is sent at this loss (ANNOUNCEMENT.md, "When it is sent"). Nothing: the loss is not known.
[[nodiscard]] std::size_t state_copies(std::optional<double> loss);
/// Never two announcements within this time. Changes within it are told together.
inline constexpr base::Duration min_spacing = std::chrono::milliseconds(3);
/// So many announcements may go at min_spacing; then only one each refill_time: a peer that changes its services
/// without end costs the air at most 1 / refill_time announcements a second.
inline constexpr std::int64_t burst_capacity = 32;
inline constexpr base::Duration refill_time = std::chrono::milliseconds(50);

/// A newcomer is answered after a random time up to this, so that a team does not answer in one instant.
inline constexpr base::Duration max_newcomer_delay = std::chrono::milliseconds(20);
/// After the first copy for a newcomer further ones follow so long after it, spread as above; more where at least
/// bad_loss is lost.
inline constexpr double bad_loss = 0.4;
inline constexpr std::array<base::Duration, 1> answer_delays = {std::chrono::milliseconds(60)};
inline constexpr std::array<base::Duration, 3> bad_answer_delays = {
    std::chrono::milliseconds(30), std::chrono::milliseconds(60), std::chrono::milliseconds(120)};
/// Presences behind them; the second only where the loss is not known, or not small. They show whom we know, too.
inline constexpr std::array<base::Duration, 2> answer_presence_delays = {std::chrono::milliseconds(120),
                                                                         std::chrono::milliseconds(400)};
/// Newcomers start copies at most once in this time; one that comes within it is answered at its end, unless copies
/// that are due anyway reach it.
inline constexpr base::Duration newcomer_spacing = std::chrono::seconds(1);
/// What answers to newcomers may cost, in datagrams of one link: ten rounds of a small state at once, so that a team
/// that is switched on within ten seconds is answered, and then one datagram in so many intervals, which is a quarter
/// of what a state in each interval would cost. A newcomer that finds it used up learns of us within one interval.
inline constexpr std::int64_t answer_capacity = 40;
inline constexpr int answer_refill_intervals = 4;

/// Repeats of the state for participants that say that they lack it, likewise in datagrams of one link: so many at
/// once, then so many in an interval; and the time in which one repeat answers all who ask.
inline constexpr std::int64_t repair_capacity = 32;
inline constexpr int repairs_per_interval = 2;
inline constexpr base::Duration max_repair_delay = std::chrono::milliseconds(10);
inline constexpr base::Duration repair_spacing = std::chrono::milliseconds(25);
/// While we lack somebody's state or doubt that it lives, we say so again and again: so many times within ask_spacing
/// of each other, then so many times in an interval. The first is enough to get through any loss; the second bounds
/// what somebody who pretends to be there can make us say.
inline constexpr std::int64_t ask_capacity = 40;
inline constexpr int asks_per_interval = 2;
inline constexpr base::Duration ask_spacing = std::chrono::milliseconds(100);
/// What we lack is said again sooner: whoever has it answers by himself, and not the whole team.
inline constexpr base::Duration lack_spacing = std::chrono::milliseconds(50);
inline constexpr base::Duration max_ask_delay = std::chrono::milliseconds(20);
/// Presences for those whom we have lost, likewise: enough for one search of half a team of ten, or for two of the
/// other nine (search.hpp).
inline constexpr std::int64_t search_capacity = 120;
inline constexpr int search_refill_intervals = 4;
/// Signs of life for those that doubt us, or doubt somebody whom we hear, likewise; one answers all who doubt
/// meanwhile.
inline constexpr std::int64_t proof_capacity = 40;
inline constexpr int proofs_per_interval = 4;
inline constexpr base::Duration proof_spacing = std::chrono::milliseconds(30);
/// Presences for who may not know us, and for whom none of our words came through: so many at once, then one in an
/// interval. None so soon after anything else that we said. For so many intervals after a change who says that he has
/// not heard us counts among them, since he may not know of it.
inline constexpr int doubtful_intervals = 8;
inline constexpr std::int64_t differing_capacity = 24;
inline constexpr base::Duration differing_spacing = std::chrono::milliseconds(150);
/// Whoever knows more of a doubted participant than the one who doubts leaves it this time to answer for itself, and up
/// to twice that.
inline constexpr base::Duration witness_delay = std::chrono::milliseconds(25);
// Once a lie about us was heard, or somebody lacks our state, it is said each time for contest_intervals: a contested
// participant must repeat each of its words (ANNOUNCEMENT.md, "A contradiction").

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

  enum class Say : std::uint8_t {
    nothing,   ///< nothing is due
    state,     ///< the whole state
    change,    ///< what has changed of late, if that can be said alone, and else the state
    presence,  ///< that we are there, with which state, and what we have heard of others
    goodbye,   ///< after stop()
  };

  /// The state changed: a copy of `what`, a change or the whole state, is due at once (or as soon as the limits allow),
  /// then the repeats. They are of the state as long as copies of it are still to come. Begins the schedule; before the
  /// first call nothing is due.
  void changed(Say what, base::Instant now);
  /// How many datagrams the whole state takes on one link, at least 1: what an answer costs. 1 until told.
  void set_size(std::size_t datagrams);
  /// How often the interval is doubled in what is said from now on, since many share the air. What all others do at the
  /// same time, too (answering newcomers, asking for somebody, witnessing), takes as many times longer.
  void set_doublings(std::uint8_t doublings, base::Instant now);
  /// Whether a longer interval is said that is not kept yet.
  [[nodiscard]] bool is_slowing() const { return announced_until_slower_ > 0; }
  /// A participant is heard that does not know us yet (a newcomer, or a claimant): as changed(), but a little later,
  /// not more often than newcomer_spacing, and only as long as the budget for answers lasts.
  void newcomer(base::Instant now);
  /// The share of datagrams that is lost on the air, for the copies of later changes. Unknown until told.
  void set_loss(std::optional<double> loss) { loss_ = loss; }
  /// A known participant says that it lacks our state: a copy is due soon, as long as the budget lasts.
  void lacked(base::Instant now);
  /// A stranger, whose state we have not heard either, says that it lacks ours: likewise, of the budget for answers.
  void lacked_by_stranger(base::Instant now);
  /// Whether we lack somebody's state, and whether we doubt that somebody lives (NeighbourTable): our presence is due
  /// again and again. Each has its own budget, so that who makes us say the one does not keep us from the other.
  void ask(bool lacks, bool doubts, base::Instant now);
  /// Whether our presence carries what sealing has to ask or to answer (sealing::Seal): it is due likewise, with a
  /// budget of its own, because who replays what others have asked makes us say it.
  void challenge(bool is_open, base::Instant now);
  /// Somebody else doubts all whom we doubt: the answer will be for us, too.
  void asked_by_another(base::Instant now);
  /// Somebody does not know the same participants as we do, perhaps not us, or has not heard us since we changed: our
  /// presence is due soon, so that he can say that he lacks our state.
  void differ(base::Instant now);
  /// Somebody was lost of late: our presence is due so long after each of our words. Nothing: nobody is looked for.
  void search(std::optional<base::Duration> spacing, base::Instant now);
  /// Somebody doubts that we live: our presence is due.
  void doubted(base::Instant now);
  /// Somebody begins our own life anew, it seems: our presence is due again and again for a short while. Once in
  /// contest_intervals.
  void deny(base::Instant now);
  /// Somebody doubts whom we hear: our presence is due, a little later.
  void bear_witness(base::Instant now);
  /// Somebody claims our identifier (IdentifierClaim::Verdict::answer): our presence is due at once, or as soon as the
  /// budget for it allows, so that a claimant hears it before it holds the identifier.
  void contested(base::Instant now);
  /// Somebody said in our name what we have not said: one copy of the state is due at once, if the budget for it is not
  /// used up. Each periodic announcement of the next contest_intervals is the state, too.
  void contradict(base::Instant now);
  /// Nothing is due any more until changed(): the identifier was lost, say.
  void pause();
  /// Only goodbyes are due from now on, the first at once, regardless of the limits.
  void stop(base::Instant now);

  /// When take() is to be asked, or base::never.
  [[nodiscard]] base::Instant due() const;
  /// What is to be sent now; the schedule moves on. Ask until it says nothing.
  [[nodiscard]] Say take(base::Instant now);
  /// Whether stop() was called and all goodbyes have been taken.
  [[nodiscard]] bool is_finished() const;

 private:
  /// Something that is said until it is answered.
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
  [[nodiscard]] base::Duration spread(base::Duration time, double share);
  [[nodiscard]] base::Duration said_interval() const { return announcement::stretched(options_.interval, doublings_); }
  /// A time that grows with the number of those that share the air.
  [[nodiscard]] base::Duration slowed(base::Duration time) const { return time * (1 << doublings_); }
  /// When the whole state or the presence is wanted, for whatever reason, and when the limits allow it.
  [[nodiscard]] base::Instant state_wanted() const;
  [[nodiscard]] base::Instant presence_wanted() const;
  [[nodiscard]] base::Instant next_copy(Say what) const;
  [[nodiscard]] bool is_insistent() const { return periodic_ < insistent_until_; }
  [[nodiscard]] base::Instant allowed() const;
  [[nodiscard]] base::Instant spaced() const;
  /// Whether the state or a change is due, and which; pays for it, and what was due until now counts as told.
  [[nodiscard]] Say take_state(base::Instant now);
  [[nodiscard]] bool take_presence(base::Instant now);
  void begin_answers(base::Instant now);
  /// Forgets copies of what is said now, and of what it says, too.
  void drop_copies(bool is_presence, base::Instant now);

  ScheduleOptions options_;
  base::Random random_;
  std::vector<Copy> copies_;  ///< of the last change that are still to come, in their order
  std::optional<double> loss_;
  std::uint8_t doublings_ = 0;
  base::Duration interval_;  ///< that is kept; shorter than the one that is said while that is new
  int announced_until_slower_ = 0;
  std::vector<base::Instant> answers_;  ///< the copies for newcomers that are still to come, in their order
  base::Instant periodic_ = base::never;
  base::Instant insistent_until_;       ///< until then the state is said each time
  base::Instant repair_ = base::never;  ///< when the state is due for who lacks it
  base::Instant search_ = base::never;  ///< when the presence is due for whom we have lost
  std::optional<base::Duration> search_spacing_;
  base::Instant proof_ = base::never;      ///< when a sign of life is due because somebody doubts us
  base::Instant testimony_ = base::never;  ///< when the presence is due because somebody doubts another one
  base::Instant denial_ = base::never;     ///< when the next one is due
  int denials_left_ = 0;
  std::optional<base::Instant> denied_;        ///< when that began last
  base::Instant contested_ = base::never;      ///< when a claim to our identifier came
  base::Instant contradiction_ = base::never;  ///< when a lie about us was heard
  base::Instant newcomer_due_ = base::never;   ///< when the copies for newcomers begin
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
