// The pairs that match, and the choice of each subscription among them.
#ifndef GEMINGA_DISCOVERY_MATCHING_PAIRS_HPP
#define GEMINGA_DISCOVERY_MATCHING_PAIRS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "discovery/matching/announced_choices.hpp"
#include "discovery/matching/arbitration/choice.hpp"
#include "discovery/matching/cause.hpp"
#include "discovery/matching/considered_by.hpp"
#include "discovery/matching/directory.hpp"
#include "discovery/matching/events.hpp"
#include "discovery/matching/judge.hpp"

namespace geminga::matching {

/// Consumers of other hosts without a limit that a publication of our own is told of. A further one waits until half of
/// them have gone, so that the walk through all who ask for it is made once for many departures.
inline constexpr std::size_t max_consumers = 1024;

/// Publications that are looked at at once when a choice has used up its candidates. With more, they are looked at in
/// steps (agenda.hpp).
inline constexpr std::size_t max_refilled_at_once = 256;

/// A pair is judged first, which changes the candidates of the subscription. To settle the subscription afterwards
/// makes its choice and tells the events of it. Every subscription that was judged must be settled.
class Pairs {
 public:
  Pairs(const Directory& directory, const Judge& judge, Events& events)
      : directory_(directory), judge_(judge), events_(events) {}
  Pairs(const Pairs&) = delete;
  Pairs& operator=(const Pairs&) = delete;

  /// A publication has come that was not there. It is in no pair.
  void add(const registry::StoredPublication& publication);
  /// The request of a subscription has been made anew; `former` is the request that it had, null where it is new. All
  /// its pairs must be judged.
  void prepare(const registry::StoredSubscription& subscription, const Request* former);
  /// Makes the pair a candidate, changes its rank, or withdraws it.
  void judge(const registry::StoredSubscription& subscription, const registry::StoredPublication& publication,
             const Cause& cause);
  /// Judges all pairs of a subscription.
  void judge_all(const registry::StoredSubscription& subscription, const Cause& cause);
  /// Chooses, and tells the events.
  void settle(const registry::StoredSubscription& subscription, Cause& cause);
  /// Judges all pairs of each of these, and settles it.
  void judge_anew(const std::vector<const registry::StoredSubscription*>& subscriptions, Cause& cause);
  /// Settles a subscription of which all pairs were judged in steps, with other settlings in between: what the cause
  /// replaced is told of every pair.
  void settle_all(const registry::StoredSubscription& subscription, Cause& cause);
  /// Remembers from here on which subscriptions take up this publication as a candidate; null: none is watched.
  void watch_takers(const registry::StoredPublication* publication) {
    watched_ = publication;
    takers_.clear();
  }
  [[nodiscard]] bool has_taken(std::uint32_t slot) const { return takers_.contains(slot); }
  /// Whether judging the pair can change anything.
  [[nodiscard]] bool concerns(const registry::StoredSubscription& subscription,
                              const registry::StoredPublication& publication) const;
  /// The publications that have room again for consumers that wait. Each is given once.
  [[nodiscard]] std::vector<const registry::StoredPublication*> take_relieved();

  /// The subscriptions whose choice has used up its candidates, and to which all that they may meet must be offered.
  /// end_refill() says that it was done.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> take_postponed() {
    return std::exchange(postponed_, {});
  }
  [[nodiscard]] bool has_postponed() const { return !postponed_.empty(); }
  void end_refill(const registry::StoredSubscription& subscription) {
    if (Chooser* chooser = find_chooser(subscription)) chooser->choice.end_refill();
  }
  void forget_postponed(const registry::StoredSubscription& subscription) { std::erase(postponed_, &subscription); }

  /// Ends all pairs of publications that are about to be erased. Gives the subscriptions that must be settled, in
  /// ascending order of key.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> withdraw(
      const std::vector<const registry::StoredPublication*>& publications, Reason reason);
  /// Ends all pairs of a subscription that is about to be erased, and tells its providers.
  void end(const registry::StoredSubscription& subscription, Reason reason, Cause& cause);

  /// The subscriptions that have a publication among their candidates.
  [[nodiscard]] const ConsideredBy& considered_by(const registry::StoredPublication& publication) const {
    return considered_by_[publication.slot];
  }
  [[nodiscard]] const Choice& choice(const registry::StoredSubscription& subscription) const {
    static const Choice none;
    const auto& chooser = choosers_[subscription.slot];
    return chooser ? chooser->choice : none;
  }
  /// Whether the reasoner has still to decide about a pair of the subscription.
  [[nodiscard]] bool is_waiting(const registry::StoredSubscription& subscription) const {
    const auto& chooser = choosers_[subscription.slot];
    return chooser && chooser->is_waiting;
  }
  /// The match of a pair that is chosen.
  [[nodiscard]] std::optional<Match> chosen_match(const registry::StoredSubscription& subscription,
                                                  const registry::StoredPublication& publication) const;
  [[nodiscard]] const AnnouncedChoices& announced() const { return announced_; }
  [[nodiscard]] bool take_choice_change() { return announced_.take_change(); }
  /// How many entries of an index were passed since the start.
  [[nodiscard]] std::uint64_t passed() const { return passed_; }

 private:
  /// A subscription that chooses.
  struct Chooser {
    Choice choice;
    bool is_waiting = false;  ///< the reasoner has still to decide about one of its pairs
    /// A service was kept from it since it cannot be reached, which no other host knows.
    bool has_withheld = false;
  };

  /// Null: no pair of the subscription was ever of interest.
  [[nodiscard]] Chooser* find_chooser(const registry::StoredSubscription& subscription) {
    return choosers_[subscription.slot].get();
  }
  /// The chooser of a subscription, which is made where there is none.
  [[nodiscard]] Chooser& chooser_of(const registry::StoredSubscription& subscription);
  /// Sets what the request and the subscription say of choosing.
  void set_terms(const registry::StoredSubscription& subscription, Chooser& chooser) const;
  /// Offers every candidate that the choice does not hold, or has that done in steps.
  void refill(const registry::StoredSubscription& subscription, const Cause& cause);
  void forget_dropped(const registry::StoredSubscription& subscription);
  /// Whether a new candidate would be dropped however well it meets the subscription, so that this need not be known.
  [[nodiscard]] bool is_hopeless(const registry::StoredSubscription& subscription,
                                 const registry::StoredPublication& publication, const Cause& cause);
  /// Whether the pair had been chosen although it was of no interest, before the subscription got a limit.
  [[nodiscard]] bool was_chosen_unseen(const registry::StoredPublication& publication, const Cause& cause) const;
  /// Whether the publication has as many consumers as it can be told of, and this one has to wait.
  [[nodiscard]] bool is_turned_away(const registry::StoredSubscription& subscription,
                                    const registry::StoredPublication& publication);

  const Directory& directory_;
  const Judge& judge_;
  Events& events_;
  AnnouncedChoices announced_;
  std::vector<ConsideredBy> considered_by_;  ///< by slot of the publication
  /// By slot. Most subscriptions of a large team are of no interest here, and have none.
  std::vector<std::unique_ptr<Chooser>> choosers_;
  std::set<ServiceKey> crowded_;  ///< publications that somebody waits for
  std::vector<const registry::StoredSubscription*> postponed_;
  const registry::StoredPublication* watched_ = nullptr;
  std::set<std::uint32_t> takers_;  ///< slots of those that have taken up `watched_`
  std::uint64_t passed_ = 0;
};

}  // namespace geminga::matching

#endif
