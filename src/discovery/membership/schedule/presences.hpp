// The presences that are said between the intervals: questions to others, and signs of life.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_PRESENCES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_PRESENCES_HPP

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "base/time.hpp"
#include "discovery/membership/schedule/occasion.hpp"
#include "discovery/membership/schedule/pace.hpp"

namespace geminga::membership {

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

/// The budget of answers to claims of our identifier, one datagram on each link: all three claims of one claimant at
/// once, and under a forger's flood still one within the 90 ms of any claim.
inline constexpr std::int64_t contest_capacity = 4;
inline constexpr base::Duration contest_refill = std::chrono::milliseconds(60);

/// The questions of our presence: whether we lack a state, and whether we doubt that a participant lives.
struct Questions {
  bool lacks = false;
  bool doubts = false;
};

/// The reasons to say our presence, beside the interval and the copies of a change. One presence serves all that are
/// due.
class Presences {
 public:
  /// `interval`: the configured one.
  explicit Presences(base::Duration interval);

  /// Sets the questions that are open. While one is, it is asked again and again.
  void ask(Questions open, Pace& pace, base::Instant now);
  /// Tells whether our presence carries a challenge or an answer of sealing, which is said again and again.
  void challenge(bool is_open, Pace& pace, base::Instant now);
  /// Tells that another participant doubts all that we doubt: our question can wait.
  void asked_by_another(Pace& pace, base::Instant now);
  /// Tells that a participant knows others than we do, or has not heard us since we changed. `last_sent`: when anything
  /// was announced last.
  void differ(std::optional<base::Instant> last_sent, Pace& pace, base::Instant now);
  /// Sets the time between two announcements of the search for lost participants. Nothing: there is no search.
  void search(std::optional<base::Duration> spacing, Pace& pace, base::Instant now);
  /// Tells that a participant doubts that we live.
  void doubted(std::optional<base::Instant> last_sent, base::Instant now);
  /// Tells that our next incarnation seems to begin, though we live. Counts once in contest_intervals.
  void deny(const Pace& pace, base::Instant now);
  /// Tells that a participant doubts another one that we hear. Returns whether no testimony was due before.
  [[nodiscard]] bool bear_witness(Pace& pace, base::Instant now);
  /// Tells that it has given a sign of life itself.
  void leave_testimony() { testimony_ = base::never; }
  /// Tells that our identifier is claimed.
  void contested(base::Instant now) { contested_.due = std::min(contested_.due, now); }

  /// When a presence is due, for any reason, within the budgets.
  [[nodiscard]] base::Instant due() const;
  /// Pays for a presence from the budgets of all reasons that are due, and plans the next denial.
  void pay(base::Instant now);
  /// Tells that a presence was said, which carries the questions and the testimony.
  void said(base::Instant now);
  /// Tells that anything was announced, which shows that we live and own the identifier.
  void announced(Pace& pace, base::Instant now);
  /// Forgets all that is due.
  void clear();

 private:
  /// A question that our presence repeats until it is answered.
  struct Question : Occasion {
    std::optional<base::Instant> asked{};  ///< when it was said last
  };

  /// The reasons that have an instant and a budget each.
  [[nodiscard]] std::array<Occasion*, 6> budgeted();
  /// When a sign of life is due, for us or for another participant.
  [[nodiscard]] base::Instant sign_due() const { return std::min(proof_.due, testimony_); }
  static void plan(Question& question, bool is_open, base::Duration spacing, Pace& pace, base::Instant now);

  Question lacks_;
  Question doubts_;
  Question challenges_;
  Occasion differs_;
  Occasion searches_;
  std::optional<base::Duration> search_spacing_;
  Occasion proof_;  ///< a sign of life, because we are doubted
  /// When a sign of life is due because another participant is doubted. The budget of proof_ pays for it.
  base::Instant testimony_ = base::never;
  base::Instant denial_ = base::never;  ///< when the next denial is due
  int denials_left_ = 0;
  std::optional<base::Instant> denied_;  ///< when the denials began last
  Occasion contested_;                   ///< our identifier is claimed
};

}  // namespace geminga::membership

#endif
