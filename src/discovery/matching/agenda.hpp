// Judging that a change leaves to later steps, so that no change from the air is more than a bounded amount of work.
#ifndef GEMINGA_DISCOVERY_MATCHING_AGENDA_HPP
#define GEMINGA_DISCOVERY_MATCHING_AGENDA_HPP

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "discovery/matching/cause.hpp"
#include "discovery/matching/directory.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/judge.hpp"
#include "discovery/matching/pairs.hpp"

namespace geminga::matching {

/// Pairs that one step judges, and entries that it passes.
inline constexpr std::size_t max_judged_in_step = 64;
inline constexpr std::size_t max_passed_in_step = 512;
/// Requests that are judged at once where a converter has come or gone; the others in steps.
inline constexpr std::size_t max_rejudged_at_once = 64;

/// The rest of changes: publications that are judged with all who may ask for them, subscriptions that are judged with
/// all that they may meet or with the services of a participant that is another by its description, and subscriptions
/// that are stale because a converter came or went. Each of them keeps what it was given until its step.
class Agenda {
 public:
  Agenda(const Editions& editions, const Directory& directory, const Judge& judge, Pairs& pairs)
      : editions_(editions), directory_(directory), judge_(judge), pairs_(pairs) {}
  Agenda(const Agenda&) = delete;
  Agenda& operator=(const Agenda&) = delete;

  [[nodiscard]] bool is_empty() const;
  /// Takes the next step. False: there was nothing left.
  bool next();
  /// Takes steps until so many pairs were judged or passed, or nothing is left.
  void take_some();
  /// Takes all steps.
  void finish() {
    while (next()) {
    }
  }

  /// Whether a publication is judged with all that have it among their candidates, too, because its identity has
  /// changed.
  enum class LookBack : std::uint8_t { none, at_candidates };
  /// Judges a publication with these subscriptions, which need not be in order, and settles each.
  void judge(const registry::StoredPublication& publication, std::unique_ptr<Cause> cause,
             std::vector<const registry::StoredSubscription*> concerned, LookBack look_back);
  /// Judges a subscription with all that it may meet, and settles it. Without a cause nothing was replaced.
  void judge(const registry::StoredSubscription& subscription, std::unique_ptr<Cause> cause);
  /// Judges the services of a participant with the subscriptions that ask for what it is, because its description has
  /// come, changed or gone.
  void judge_services_of(ParticipantId participant);
  void judge_anew(const std::vector<const registry::StoredSubscription*>& subscriptions);
  /// Takes up the consumers that wait for a publication which has room again.
  void relieve();
  /// Judges a subscription at once if it is stale.
  void catch_up(const registry::StoredSubscription& subscription);

  /// An entry is about to be erased.
  void forget(const registry::StoredPublication& publication);
  void forget(const registry::StoredSubscription& subscription);
  /// An entry is about to be judged as a whole.
  void supersede(const registry::StoredPublication& publication);
  void supersede(const registry::StoredSubscription& subscription);

  /// How many entries were passed since the start.
  [[nodiscard]] std::uint64_t passed() const { return passed_; }

 private:
  /// A publication on its way to those who may ask for it.
  struct Spread {
    const registry::StoredPublication* publication = nullptr;
    std::unique_ptr<Cause> cause;  ///< null: nothing was replaced
    std::vector<const registry::StoredSubscription*> left;
    std::optional<std::uint32_t> look_back{};  ///< the slot from which on its candidates are looked at, behind `left`
    std::vector<bool> is_done;                 ///< by slot of the subscription

    [[nodiscard]] bool is_over() const { return left.empty() && !look_back; }
  };
  /// A subscription on its way through what it may meet.
  struct Review {
    enum class Kind : std::uint8_t {
      all,     ///< all pairs are judged
      refill,  ///< those that are no candidates
      chains,  ///< those whose chain has changed
    };
    const registry::StoredSubscription* subscription = nullptr;
    Kind kind = Kind::all;
    std::unique_ptr<Cause> cause;  ///< null: nothing was replaced
    std::vector<const registry::StoredPublication*> candidates;
    std::vector<const registry::StoredPublication*> left;
  };

  /// Counts the work of one step.
  class Step;

  void proceed(Spread& spread);
  void judge_one(Spread& spread, const registry::StoredSubscription& subscription);
  void proceed(Review& review);
  void judge_chain(const registry::StoredSubscription& subscription, const registry::StoredPublication& publication,
                   const Cause& cause);
  [[nodiscard]] Review review(const registry::StoredSubscription& subscription, Review::Kind kind) const;
  void take_postponed();
  void take_described();
  bool take_stale();

  const Editions& editions_;
  const Directory& directory_;
  const Judge& judge_;
  Pairs& pairs_;
  std::deque<Spread> spreads_;
  std::deque<Review> reviews_;
  std::vector<const registry::StoredSubscription*> anew_;  ///< subscriptions whose review has not begun
  /// Subscriptions that ask for what participants are, each with one whose services it has to judge again.
  std::set<std::pair<ServiceKey, ParticipantId>> described_;
  std::uint64_t passed_ = 0;
};

}  // namespace geminga::matching

#endif
