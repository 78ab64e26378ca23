// The publications and subscriptions that are known, with what each vocabulary at work makes of them.
#ifndef GEMINGA_DISCOVERY_MATCHING_DIRECTORY_HPP
#define GEMINGA_DISCOVERY_MATCHING_DIRECTORY_HPP

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "discovery/matching/arbitration/reason.hpp"
#include "discovery/matching/candidates.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/preparation.hpp"
#include "discovery/matching/request.hpp"
#include "discovery/registry/table.hpp"

namespace geminga::matching {

/// A subscription as it was until another one with its key took its place.
struct ReplacedSubscription {
  std::shared_ptr<const registry::SubscriptionEntry> entry;
  Request request;
  registry::Generation generation = registry::Generation::even;  ///< of the edition of the request
};

/// The home of the registry. It files what comes and takes out what goes; it judges nothing and tells nobody.
class Directory {
 public:
  Directory(const Editions& editions, const Preparation& preparation);
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;

  void share(const std::shared_ptr<registry::SharedEntries>& entries) {
    publications_.share(entries);
    subscriptions_.share(entries);
  }

  /// Adds an entry whose key is not there yet. A request is made of its subscription by the vocabulary in force.
  const registry::StoredPublication& add(registry::PublicationEntry entry);
  const registry::StoredSubscription& add(registry::SubscriptionEntry entry, Request request);
  /// Puts an entry with the same key into the place of one, and gives what was there.
  std::shared_ptr<const registry::PublicationEntry> replace(const registry::StoredPublication& stored,
                                                            registry::PublicationEntry entry);
  ReplacedSubscription replace(const registry::StoredSubscription& stored, registry::SubscriptionEntry entry,
                               Request request);
  /// Says that an entry was heard of again, as it is.
  void refresh(const registry::StoredPublication& stored, base::Instant updated) {
    publications_.refresh(stored, updated);
  }
  void refresh(const registry::StoredSubscription& stored, base::Instant updated) {
    subscriptions_.refresh(stored, updated);
  }
  /// Marks an entry as about to be erased: it meets nothing, and a publication converts nothing.
  void retire(const std::vector<const registry::StoredPublication*>& publications, Reason reason);
  void retire(const registry::StoredPublication& stored, Reason reason) { retire(std::vector{&stored}, reason); }
  void retire(const registry::StoredSubscription& stored) { known(stored).is_leaving = true; }
  void erase(const registry::StoredPublication& stored);
  void erase(const registry::StoredSubscription& stored);

  /// Makes the indexes of an edition that has come, and of one that goes.
  void open_indexes(const Edition& edition);
  void close_indexes(const Edition& edition);
  /// Looks up a publication in the vocabulary of an edition, and files it by that.
  void file(const registry::StoredPublication& stored, const Edition& edition);
  /// Takes a publication out of the index of an edition.
  void unfile(const registry::StoredPublication& stored, const Edition& edition);
  /// Takes a subscription out of the index that it is in. From here on it is judged by the edition in force.
  void unfile(const registry::StoredSubscription& stored);
  /// Files an unfiled subscription by the edition in force, from whose vocabulary its request was made. Gives the
  /// former request.
  Request file(const registry::StoredSubscription& stored, Request request);

  [[nodiscard]] const registry::Publications& publications() const { return publications_; }
  [[nodiscard]] const registry::Subscriptions& subscriptions() const { return subscriptions_; }
  [[nodiscard]] const registry::StoredSubscription& subscription_at(std::uint32_t slot) const {
    return *of_subscription_[slot].stored;
  }
  /// Whether it is about to be erased.
  [[nodiscard]] bool is_going(const registry::StoredPublication& stored) const {
    return known(stored).leaves.has_value();
  }
  [[nodiscard]] bool is_going(const registry::StoredSubscription& stored) const { return known(stored).is_leaving; }
  /// Why it is about to be erased; nothing where it is not.
  [[nodiscard]] std::optional<Reason> reason_to_go(const registry::StoredPublication& stored) const {
    return known(stored).leaves;
  }

  [[nodiscard]] const Request& request(const registry::StoredSubscription& stored) const {
    return *known(stored).request;
  }
  /// The edition that a subscription is judged by.
  [[nodiscard]] const Edition& edition_of(const registry::StoredSubscription& stored) const {
    return editions_.by_generation(known(stored).generation);
  }
  [[nodiscard]] const Edition& edition_of(const ReplacedSubscription& replaced) const {
    return editions_.by_generation(replaced.generation);
  }
  [[nodiscard]] const Classes& classes(const registry::StoredPublication& stored, const Edition& edition) const {
    return known(stored).classes[std::to_underlying(edition.generation)];
  }
  /// A publication with all that an edition knows of it.
  [[nodiscard]] Offer offer(const registry::StoredPublication& stored, const Edition& edition) const {
    const KnownPublication& publication = known(stored);
    const auto generation = std::to_underlying(edition.generation);
    return {stored.entry, audience(publication), publication.classes[generation],
            publication.signatures[generation].get()};
  }
  /// How a publication is turned into what a subscription asks for; null where it is not.
  [[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain(const registry::StoredSubscription& subscription,
                                                               const registry::StoredPublication& publication) const;

  /// The subscriptions that a publication may meet, each once, in ascending order of key.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> subscriptions_for(
      const registry::StoredPublication& publication) const;
  /// The same in no particular order, and perhaps more than once. Looks at none of them.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> subscriptions_found_for(
      const registry::StoredPublication& publication) const;
  /// The subscriptions that ask for what the provider's participant is.
  [[nodiscard]] const std::set<ServiceKey>& asking_on() const { return asking_on_; }
  /// Every slot of a subscription is less than this.
  [[nodiscard]] std::size_t subscription_slots() const { return of_subscription_.size(); }
  /// Calls `visit` once for each publication that a subscription may meet, those that are about to be erased included.
  /// `visit` gives true to stop.
  template <typename Visit>
  void visit_publications_for(const registry::StoredSubscription& subscription, const Visit& visit) const {
    const Subscription& asked = subscription.entry.subscription;
    visit_publications(publications_, asked.identity, request(subscription).classes, asked.weakest,
                       edition_of(subscription), visit);
  }
  /// The same of a subscription that need not be known, from which `request` was made by the vocabulary in force.
  template <typename Visit>
  void visit_publications_for(const Subscription& asked, const Request& request, const Visit& visit) const {
    visit_publications(publications_, asked.identity, request.classes, asked.weakest, editions_.in_force(), visit);
  }

  /// How many entries were filed, unfiled or passed in an index since the start.
  [[nodiscard]] std::uint64_t filed() const { return filed_; }

 private:
  struct KnownPublication {
    std::array<Classes, 2> classes;                              ///< by generation
    std::array<std::unique_ptr<const Signature>, 2> signatures;  ///< by generation; null: none is stated
    std::unique_ptr<const Audience> audience;                    ///< null: it is for everybody
    std::optional<Reason> leaves;                                ///< why it is about to be erased
    std::uint64_t arrival = 0;                                   ///< greater than that of those that came before it
  };
  struct KnownSubscription {
    const registry::StoredSubscription* stored = nullptr;
    std::shared_ptr<const Request> request;
    registry::Generation generation = registry::Generation::even;  ///< of the edition that it is judged by
    bool is_leaving = false;                                       ///< it is about to be erased
  };

  [[nodiscard]] KnownPublication& known(const registry::StoredPublication& stored) {
    return of_publication_[stored.slot];
  }
  [[nodiscard]] const KnownPublication& known(const registry::StoredPublication& stored) const {
    return of_publication_[stored.slot];
  }
  [[nodiscard]] KnownSubscription& known(const registry::StoredSubscription& stored) {
    return of_subscription_[stored.slot];
  }
  [[nodiscard]] const KnownSubscription& known(const registry::StoredSubscription& stored) const {
    return of_subscription_[stored.slot];
  }
  [[nodiscard]] static const Audience& audience(const KnownPublication& publication) {
    return publication.audience ? *publication.audience : Audience::everybody();
  }
  [[nodiscard]] FilingPlan plan(const registry::SubscriptionEntry& entry, const Request& request) const {
    return FilingPlan::of_subscription(request.classes, entry.subscription.weakest, editions_.in_force());
  }
  /// A request as it is kept: all that state nothing are one.
  [[nodiscard]] std::shared_ptr<const Request> kept(Request request) const;
  /// Looks up and files a publication that was just stored.
  void take_in(const registry::StoredPublication& stored);
  /// Converters that come or go make the subscription stale from here on, or do so no more.
  void watch(const registry::StoredSubscription& stored);
  void unwatch(const registry::StoredSubscription& stored);

  const Editions& editions_;
  const Preparation& preparation_;
  const std::shared_ptr<const Request> plain_ = std::make_shared<const Request>(Request::plain());
  registry::Publications publications_;
  registry::Subscriptions subscriptions_;
  std::vector<KnownPublication> of_publication_;    ///< by slot
  std::vector<KnownSubscription> of_subscription_;  ///< by slot
  std::set<ServiceKey> asking_on_;
  std::uint64_t arrivals_ = 0;
  std::uint64_t filed_ = 0;
};

}  // namespace geminga::matching

#endif
