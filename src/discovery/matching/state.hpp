// What the matcher knows: the registry, the pairs that match, and the choice of each subscription.
#ifndef GEMINGA_DISCOVERY_MATCHING_STATE_HPP
#define GEMINGA_DISCOVERY_MATCHING_STATE_HPP

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "discovery/matching/arbitration.hpp"
#include "discovery/matching/audience.hpp"
#include "discovery/matching/candidates.hpp"
#include "discovery/matching/clash.hpp"
#include "discovery/matching/considered_by.hpp"
#include "discovery/matching/matcher.hpp"
#include "discovery/matching/obstacle.hpp"
#include "discovery/matching/request.hpp"
#include "discovery/matching/standing.hpp"
#include "discovery/registry/fields.hpp"
#include "discovery/registry/table.hpp"

namespace geminga::matching {

/// A remote consumer that asks for more providers than this and has not announced its choice is treated as one that
/// takes all: its choice then needs no other candidates than our own publications. The price is that a provider may be
/// told of a consumer that has better ones.
inline constexpr std::uint32_t max_counted_providers = 16;

/// A consumer of our own that asks for all is given the best of so many. Each pair costs memory here and in its peer,
/// and more services may be announced than a host has memory for pairs.
inline constexpr std::uint32_t max_given = 1024;

/// Consumers of other hosts without a limit that a publication of our own is told of. A further one waits until half of
/// them have gone, so that the walk through all who ask for it is made once for many departures.
inline constexpr std::size_t max_consumers = 1024;

/// Requests that are judged at once where a converter has come or gone; the others in steps.
inline constexpr std::size_t max_rejudged_at_once = 64;

/// Classes below that of an offer that are looked at for those who ask for something narrower.
inline constexpr std::size_t max_searched_classes = 256;

/// A publication that meets a request.
struct Ranked {
  const registry::PublicationEntry* publication = nullptr;  ///< borrowed until the next change of the matcher
  Rank rank;
};

/// Every change runs in three steps: the registry takes it, the pairs that it concerns are judged again, and each
/// subscription whose candidates changed is settled once, which gives the events.
class Matcher::State {
 public:
  State(vocabulary::Vocabulary vocabulary, Placing placing, Overlapping overlapping);

  void put(registry::PublicationEntry entry);
  void put(registry::SubscriptionEntry entry, Telling telling);
  /// Removes all of these at once, so that nothing that is about to go takes another's place.
  void remove(const std::vector<const registry::StoredPublication*>& publications,
              const std::vector<const registry::StoredSubscription*>& subscriptions, Reason reason);
  void begin_departure(ParticipantId participant, Reason reason);
  [[nodiscard]] bool depart_next();
  void begin_vocabulary(vocabulary::Vocabulary next);
  [[nodiscard]] bool file_next();
  void put_in_force();
  [[nodiscard]] bool rematch_next();
  bool take_prepared(vocabulary::Vocabulary prepared);
  void place_again();
  /// By the vocabulary in force. `must_convert`: also where it does not ask for conversions, to say what they cost.
  [[nodiscard]] Request prepare(const registry::SubscriptionEntry& entry, bool must_convert = true) const;

  [[nodiscard]] std::vector<Ranked> match(const registry::SubscriptionEntry& entry, const Request& request) const;
  [[nodiscard]] std::optional<Standing> standing(const registry::StoredSubscription& subscription,
                                                 const registry::StoredPublication& publication);
  [[nodiscard]] Standing standing(const registry::StoredSubscription& subscription,
                                  const registry::StoredPublication& publication, const Place& place);
  /// The limit that ranks are compared with; 0 is none.
  [[nodiscard]] static std::size_t counted_limit(const registry::SubscriptionEntry& subscription);
  [[nodiscard]] std::optional<Match> meets(const registry::SubscriptionEntry& asked, const Request& request,
                                           const registry::PublicationEntry& publication) const;
  [[nodiscard]] Finding examine(const registry::SubscriptionEntry& asked, const Request& request,
                                const registry::PublicationEntry& offered) const;
  /// Matcher::examine_requests(), examine_near(), known_choice().
  bool examine_requests(const std::optional<ServiceKey>& after, const registry::PublicationEntry& offered,
                        const VisitFinding& visit) const;
  std::size_t examine_near(const registry::PublicationEntry& offered, std::size_t most,
                           const VisitFinding& visit) const;
  [[nodiscard]] std::size_t waiting_converters() const { return in_force_.converters->waiting_count(); }
  [[nodiscard]] std::optional<std::vector<ServiceKey>> known_choice(
      const registry::SubscriptionEntry& subscription) const;
  [[nodiscard]] std::vector<ServiceKey> chosen(const ServiceKey& subscription) const;
  [[nodiscard]] std::vector<ServiceKey> consumers(const ServiceKey& publication) const;
  [[nodiscard]] std::optional<Match> given(const ServiceKey& subscription, const ServiceKey& publication) const;
  [[nodiscard]] bool is_served(const registry::SubscriptionEntry& subscription) const;
  [[nodiscard]] bool is_used(const registry::PublicationEntry& publication) const;
  [[nodiscard]] std::set<std::string> converters_in_use() const;

  /// Whether a number and a concept do not meet because the number is that of another concept, too.
  [[nodiscard]] bool is_kept_apart(const Identity& offered, const Identity& requested) const;

  Edition in_force_;
  Placing placing_;
  Overlapping overlapping_;
  registry::Publications publications_;
  registry::Subscriptions subscriptions_;
  std::vector<Event> events_;
  std::vector<Clash> clashes_;
  mutable std::uint64_t judged_ = 0;
  std::uint64_t filed_ = 0;

  /// Whether it is about to be erased.
  [[nodiscard]] bool is_going(const registry::StoredPublication& stored) const {
    return of_publication_[stored.slot].leaves.has_value();
  }
  [[nodiscard]] bool is_going(const registry::StoredSubscription& stored) const {
    return of_subscription_[stored.slot].is_leaving;
  }

  /// The one that a subscription is judged by.
  [[nodiscard]] const Edition& edition_of(const registry::StoredSubscription& subscription) const {
    return edition_of(of_subscription_[subscription.slot].generation);
  }

  /// What is left of a departure. What is in it is judged as if it were gone already.
  struct Departure {
    std::vector<const registry::StoredPublication*> publications;
    std::vector<const registry::StoredSubscription*> subscriptions;
    Reason reason = Reason::withdrawn;
    std::set<Id32> numbers;  ///< clashing ones of those that were erased
  };
  std::deque<Departure> departures_;
  /// Judges a subscription now if its chains may have changed.
  void catch_up(const registry::StoredSubscription& subscription);
  /// The same for the next one. False: there is none.
  [[nodiscard]] bool rejudge_next();
  [[nodiscard]] bool has_stale() const {
    return !in_force_.converters->stale().empty() ||
           (other_.converters != nullptr && !other_.converters->stale().empty());
  }
  /// How what is offered is turned into what is asked for; null where it is not.
  [[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain_of(const registry::StoredSubscription& subscription,
                                                                  const registry::StoredPublication& publication) const;

  bool has_choice_changed_ = false;  ///< Matcher::take_choice_change()
  [[nodiscard]] std::vector<ServiceKey> announced_choice(const ServiceKey& subscription) const {
    const auto* stored = subscriptions_.find(subscription);
    return stored == nullptr ? std::vector<ServiceKey>() : of_subscription_[stored->slot].announced_choice;
  }

 private:
  struct OfPublication {
    std::array<Classes, 2> classes;                              ///< by generation
    std::array<std::unique_ptr<const Signature>, 2> signatures;  ///< by generation; null: none is stated
    std::unique_ptr<const Audience> audience;                    ///< null: it is for everybody
    ConsideredBy considered_by;
    std::optional<Reason> leaves;  ///< it is about to be erased, for this reason
    std::uint64_t arrival = 0;     ///< greater than that of those that came before it
  };
  struct OfSubscription {
    const registry::StoredSubscription* stored = nullptr;
    Request request;
    Choice choice;
    registry::Generation generation = registry::Generation::even;  ///< of the edition that it is judged by
    bool is_leaving = false;                                       ///< it is about to be erased
    bool is_waiting = false;    ///< whether some concept overlaps with what it asks for waits to be decided
    bool is_contested = false;  ///< whether it had to choose when it was settled
    std::vector<ServiceKey> announced_choice;  ///< Matcher::announced_choice()
  };
  /// How far the change to another vocabulary is. A subscription is judged by one of them at any time, and filed in its
  /// index alone; what is offered is known by both from the beginning of `filing` to the end of `rematching`.
  enum class Stage {
    none,
    filing,      ///< what is offered is filed by the next one, too; everything is judged by the one in force
    rematching,  ///< the next one is in force: one subscription after the other is judged by it
    unfiling,    ///< what is offered is taken out of the index of the former one
  };

  [[nodiscard]] OfPublication& of(const registry::StoredPublication& stored) { return of_publication_[stored.slot]; }
  [[nodiscard]] OfSubscription& of(const registry::StoredSubscription& stored) { return of_subscription_[stored.slot]; }
  [[nodiscard]] const Classes& classes(const registry::StoredPublication& stored, const Edition& edition) const {
    return of_publication_[stored.slot].classes[std::to_underlying(edition.generation)];
  }
  [[nodiscard]] const Audience& audience(const registry::StoredPublication& stored) const {
    const auto& stated = of_publication_[stored.slot].audience;
    return stated ? *stated : Audience::everybody();
  }
  /// With all that is known of it.
  [[nodiscard]] Offer offer(const registry::StoredPublication& stored, const Edition& edition) const {
    const OfPublication& known = of_publication_[stored.slot];
    const auto generation = std::to_underlying(edition.generation);
    return {stored.entry, audience(stored), known.classes[generation], known.signatures[generation].get()};
  }
  [[nodiscard]] const Edition& edition_of(registry::Generation generation) const {
    return generation == in_force_.generation ? in_force_ : other_;
  }
  [[nodiscard]] bool is_known_by_both() const { return stage_ == Stage::filing || stage_ == Stage::rematching; }
  /// Looks up what is offered in a vocabulary, and files it by that.
  void file(const registry::StoredPublication& stored, const Edition& edition);
  /// It is about to be erased: it meets nothing and converts nothing any more.
  void retire(const registry::StoredPublication& stored, Reason reason);
  /// Where it preferred others until now its candidates are about to be ranked anew.
  void release_if_others(const registry::StoredSubscription& subscription, const Preferences& preferences);
  /// A subscription has been prepared anew: it is told of converters that concern it, and is not stale.
  void watch(const registry::StoredSubscription& stored);
  void unwatch(const registry::StoredSubscription& stored);
  /// Judges each candidate of a stale subscription whose chain is not what it was.
  void rejudge(const registry::StoredSubscription& subscription);
  void rejudge_some();
  /// Ends all departures at once, because somebody comes back before his is over.
  void finish_departures() {
    while (depart_next()) {
    }
  }
  void erase(const registry::StoredPublication& publication, std::set<Id32>& numbers);
  void erase(const registry::StoredSubscription& subscription, std::set<Id32>& numbers);
  /// Judges a subscription by the vocabulary in force, after it was filed by it.
  void rematch(const registry::StoredSubscription& subscription) {
    rematch(subscription, prepare(subscription.entry, false));
  }
  void rematch(const registry::StoredSubscription& subscription, Request request);
  /// The same unless a request of our own waits for the reasoner: then nothing is done, so that it loses nothing that
  /// it has. Whether it was done.
  [[nodiscard]] bool rematch_if_answered(const registry::StoredSubscription& subscription);
  [[nodiscard]] bool unfile_next();
  [[nodiscard]] bool place_next();
  /// The subscriptions that an offer may meet, each once, in ascending order of key.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> subscriptions_for(
      const registry::StoredPublication& publication) const;
  [[nodiscard]] std::optional<Match> meets(const registry::StoredSubscription& subscription,
                                           const registry::StoredPublication& publication) const;

  /// By the vocabulary in force.
  [[nodiscard]] Finding examine(const registry::StoredSubscription& stored, const Offer& offer) const;
  /// Adds, up to `most`, those who ask for something below a class, the nearest first; gives how many classes were
  /// looked at.
  std::size_t add_narrower(vocabulary::ClassNumber concept_class, std::size_t most,
                           std::vector<const registry::StoredSubscription*>& found) const;

  const registry::StoredPublication& store(registry::PublicationEntry entry, const registry::StoredPublication* known);
  const registry::StoredSubscription& store(registry::SubscriptionEntry entry,
                                            const registry::StoredSubscription* known);
  /// The limit that arbitration works with; 0 is none.
  [[nodiscard]] static std::uint32_t limit_of(const registry::SubscriptionEntry& subscription);
  /// Whether the pair can ever cause an event or decide about another one that can.
  [[nodiscard]] static bool is_of_interest(const registry::SubscriptionEntry& subscription,
                                           const registry::PublicationEntry& publication);
  /// Of a consumer on another host that has announced its choice: whether this is in it.
  [[nodiscard]] static bool is_announced_choice(const registry::SubscriptionEntry& subscription,
                                                const registry::PublicationEntry& publication);
  /// What a subscription of our own has to announce after it was settled.
  void note_choice(const registry::StoredSubscription& subscription);
  /// The one place where a pair is judged, and counted.
  [[nodiscard]] std::optional<Match> meet(const registry::SubscriptionEntry& asked, const Request& request,
                                          const registry::StoredPublication& offered, const Edition& edition) const;
  /// Finds out whether the number is that of two concepts, after what has come or gone. Gives the subscriptions that
  /// must be judged anew. All whose number it is are told of it when it begins, and of each that comes to have it.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> review(Id32 number, bool has_newcomer);
  void tell_clash(Id32 number, std::span<const Identity* const> concepts);
  void judge_anew(const std::vector<const registry::StoredSubscription*>& subscriptions);
  /// Whether the publication has as many consumers as it can be told of, and this one has to wait.
  [[nodiscard]] bool is_turned_away(const registry::StoredSubscription& subscription,
                                    const registry::StoredPublication& publication);
  /// Takes up those that wait for a publication that has room again.
  void relieve();
  /// Whether a new candidate would be dropped however well it meets the subscription, so that this need not be known.
  [[nodiscard]] bool is_hopeless(const registry::StoredSubscription& subscription,
                                 const registry::StoredPublication& publication);
  void judge(const registry::StoredSubscription& subscription, const registry::StoredPublication& publication);
  void judge_all(const registry::StoredSubscription& subscription);
  /// Offers every candidate that the choice does not hold.
  void refill(const registry::StoredSubscription& subscription);
  void forget_dropped(const registry::StoredSubscription& subscription);
  void forget(const registry::StoredSubscription& subscription, Reason reason);
  void settle(const registry::StoredSubscription& subscription);
  /// Whether the pair had been chosen although it was of no interest, before the subscription got a limit.
  [[nodiscard]] bool was_chosen_unseen(const registry::StoredPublication& publication) const;

  void tell_consumer(Change change, const registry::StoredSubscription& subscription,
                     const registry::StoredPublication& publication, Match match, Reason reason = Reason::withdrawn);
  void tell_provider(Change change, const registry::StoredSubscription& subscription,
                     const registry::StoredPublication& publication, Match match, Reason reason = Reason::withdrawn);
  [[nodiscard]] const registry::PublicationEntry& as_told(const registry::StoredPublication& publication) const;
  [[nodiscard]] const registry::SubscriptionEntry& as_told(const registry::StoredSubscription& subscription) const;

  Edition other_;  ///< while filing the next one, then the former one
  Stage stage_ = Stage::none;
  std::optional<ServiceKey> at_;  ///< the last entry that the change has dealt with; nothing: none yet
  /// Asks the reasoner whatever judging this subscription will ask it. False: some of it waits to be decided.
  [[nodiscard]] bool asks_overlaps(const registry::StoredSubscription& subscription, const Request& request) const;
  mutable bool has_waited_ = false;  ///< a question to the reasoner has been left waiting
  /// The walk over the subscriptions whose expressions have no place, and those that wait for the reasoner, by the last
  /// one that it passed.
  struct PlaceWalk {
    std::optional<ServiceKey> at;
    bool must_repeat;
  };
  std::optional<PlaceWalk> placing_walk_;

  std::uint64_t arrivals_ = 0;
  std::set<ServiceKey> crowded_;                 ///< publications that somebody waits for
  std::set<Id32> clashing_;                      ///< numbers of two concepts or more
  std::vector<OfPublication> of_publication_;    ///< by slot
  std::vector<OfSubscription> of_subscription_;  ///< by slot

  /// The entry that a put() is replacing, as its peers were told of it.
  template <typename Entry>
  struct Replaced {
    const registry::Stored<Entry>* stored = nullptr;
    Entry before;
  };
  /// What was told last, so that many events about it share one copy. Forgotten when another cause begins.
  template <typename Entry>
  struct Snapshot {
    const Entry* of = nullptr;
    std::shared_ptr<const Entry> copy;
  };
  template <typename Entry>
  static std::shared_ptr<const Entry> snapshot(Snapshot<Entry>& last, const Entry& entry) {
    if (last.of != &entry) last = {&entry, std::make_shared<const Entry>(entry)};
    return last.copy;
  }
  void begin_cause() {
    told_publication_ = {};
    told_subscription_ = {};
  }
  Snapshot<registry::PublicationEntry> told_publication_;
  Snapshot<registry::SubscriptionEntry> told_subscription_;
  Replaced<registry::PublicationEntry> replaced_publication_;
  Replaced<registry::SubscriptionEntry> replaced_subscription_;
  Request replaced_request_;
  registry::Generation replaced_generation_ = registry::Generation::even;  ///< of the edition of replaced_request_
  bool replaced_is_silent_ = false;                                        ///< nothing changed that is told
  bool replaced_was_clashing_ = false;                    ///< whether its number was that of two concepts
  const registry::StoredSubscription* untold_ = nullptr;  ///< its own consumer gets no events (Telling::providers)
};

}  // namespace geminga::matching

#endif
