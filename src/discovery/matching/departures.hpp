// The end of publications and subscriptions: at once, or in steps where a whole participant leaves.
#ifndef GEMINGA_DISCOVERY_MATCHING_DEPARTURES_HPP
#define GEMINGA_DISCOVERY_MATCHING_DEPARTURES_HPP

#include <deque>
#include <set>
#include <vector>

#include "discovery/matching/agenda.hpp"
#include "discovery/matching/clashes.hpp"
#include "discovery/matching/directory.hpp"
#include "discovery/matching/pairs.hpp"

namespace geminga::matching {

class Departures {
 public:
  Departures(Directory& directory, Clashes& clashes, Pairs& pairs, Agenda& agenda)
      : directory_(directory), clashes_(clashes), pairs_(pairs), agenda_(agenda) {}

  /// Removes all of these at once, so that nothing that is about to go takes another's place. None may be going yet.
  void remove(const std::vector<const registry::StoredPublication*>& publications,
              const std::vector<const registry::StoredSubscription*>& subscriptions, Reason reason);

  void remove(const registry::StoredPublication& publication, Reason reason) { remove({&publication}, {}, reason); }
  void remove(const registry::StoredSubscription& subscription, Reason reason) { remove({}, {&subscription}, reason); }

  /// Matcher::begin_departure(), begin_removal() and take_step().
  void begin(ParticipantId participant, Reason reason);
  void begin(const registry::StoredPublication& publication, Reason reason) { begin({&publication}, {}, reason); }
  void begin(const registry::StoredSubscription& subscription, Reason reason) { begin({}, {&subscription}, reason); }
  bool next();
  [[nodiscard]] bool is_any() const { return !departures_.empty(); }
  /// Ends all departures at once, because a participant comes back before its departure is over.
  void finish() {
    while (next()) {
    }
  }
  /// How many entries of an index were passed since the start.
  [[nodiscard]] std::uint64_t passed() const { return passed_; }

 private:
  /// The rest of one participant. All of it is judged as if it were gone already.
  struct Departure {
    std::vector<const registry::StoredPublication*> publications;
    std::vector<const registry::StoredSubscription*> subscriptions;
    Reason reason = Reason::withdrawn;
    std::set<Id32> numbers;  ///< clashing ones of those that were erased
  };

  /// The numbers that are looked at in one step when entries with clashing ones were erased.
  static constexpr std::size_t max_reviewed_in_step = 16;

  void begin(std::vector<const registry::StoredPublication*> publications,
             std::vector<const registry::StoredSubscription*> subscriptions, Reason reason);
  /// Ends the pairs of a publication with one subscription; false where there is none left.
  bool end_one_consumer(const Departure& departure, const registry::StoredPublication& publication);
  /// Erases an entry of offers or requests that is in no pair, and adds its number where it clashes.
  template <typename Owner, typename Stored>
  void erase(Owner& owner, const Stored& stored, std::set<Id32>& numbers) {
    if (clashes_.contains(stored.identity)) numbers.insert(stored.identity);
    agenda_.forget(stored);
    const ServiceKey key = stored.entry.key;
    owner.erase(stored);
    if (key == description_key(key.participant)) agenda_.judge_services_of(key.participant);
  }
  /// Has judged what may be another match after entries with these clashing numbers were erased. Takes some of them.
  void review(std::set<Id32>& numbers);

  Directory& directory_;
  Clashes& clashes_;
  Pairs& pairs_;
  Agenda& agenda_;
  std::deque<Departure> departures_;
  std::uint64_t passed_ = 0;
};

}  // namespace geminga::matching

#endif
