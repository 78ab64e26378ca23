// The schedule of announcements: every interval, at once on a change and quickly again, never too often.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_SCHEDULE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_SCHEDULE_HPP

#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/time.hpp"
#include "discovery/membership/schedule/answers.hpp"
#include "discovery/membership/schedule/copies.hpp"
#include "discovery/membership/schedule/pace.hpp"
#include "discovery/membership/schedule/presences.hpp"
#include "discovery/membership/schedule/repairs.hpp"
#include "discovery/membership/schedule/token_bucket.hpp"

namespace geminga::membership {

/// The configuration of a schedule. Each time is argued in ANNOUNCEMENT.md, "When it is sent".
struct ScheduleOptions {
  /// The time between two announcements of an unchanged state, where few share the air.
  base::Duration interval = std::chrono::seconds(2);
};
/// The least time between two announcements. Changes within it are told together.
inline constexpr base::Duration min_spacing = std::chrono::milliseconds(3);
/// The announcements that may go at min_spacing; after them one each refill_time. A peer that changes its services
/// without end costs the air at most 1 / refill_time announcements a second.
inline constexpr std::int64_t burst_capacity = 32;
inline constexpr base::Duration refill_time = std::chrono::milliseconds(50);

/// The number of goodbyes at the end, and the time between them.
inline constexpr std::size_t goodbye_copies = 3;
inline constexpr base::Duration goodbye_spacing = std::chrono::milliseconds(10);

/// One participant's schedule. Deterministic for its seed and its calls. It knows nothing of what is announced: take()
/// tells its caller what to announce on all interfaces.
class Schedule {
 public:
  /// `seed`: random bits for the jitter.
  Schedule(ScheduleOptions options, std::uint64_t seed);

  using Say = membership::Say;

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
  [[nodiscard]] bool is_slowing() const { return pace_.is_slowing(); }
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
  /// Sets the questions that are open (NeighbourTable). While one is, our presence is due again and again. Each has its
  /// own budget, so that a forger of the one does not keep us from the other.
  void ask(Questions open, base::Instant now);
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
  void leave_testimony() { presences_.leave_testimony(); }
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
  /// When the state or the presence is wanted, for any reason, within its own budgets.
  [[nodiscard]] base::Instant state_wanted() const;
  [[nodiscard]] base::Instant presence_wanted() const;
  /// Whether the periodic announcement is the state.
  [[nodiscard]] bool is_insistent() const { return repairs_.is_insistent(periodic_); }
  [[nodiscard]] base::Instant allowed() const;
  [[nodiscard]] base::Instant spaced() const;
  /// The first instant at which a participant that lacks the state cannot have missed one that is on its way.
  [[nodiscard]] base::Instant after_state() const;
  /// Returns the state or a change if one is due, and pays for it. What was due until now counts as said.
  [[nodiscard]] Say take_state(base::Instant now);
  [[nodiscard]] bool take_presence(base::Instant now);

  Pace pace_;
  Copies copies_;
  Answers answers_;
  Repairs repairs_;
  Presences presences_;
  std::optional<double> loss_;
  base::Instant periodic_ = base::never;
  std::optional<base::Instant> last_sent_;   ///< when anything was announced
  std::optional<base::Instant> state_sent_;  ///< when the state was
  std::int64_t size_ = 1;
  TokenBucket announcements_{burst_capacity, refill_time};
  std::size_t goodbyes_left_ = 0;
  base::Instant goodbye_due_ = base::never;
  bool is_running_ = false;
  bool is_stopping_ = false;
};

}  // namespace geminga::membership

#endif
