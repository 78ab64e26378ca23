// The subscriptions that are known, each with the request that the vocabulary which judges it makes of it.
#ifndef GEMINGA_DISCOVERY_MATCHING_REQUESTS_HPP
#define GEMINGA_DISCOVERY_MATCHING_REQUESTS_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <vector>

#include "discovery/matching/candidates.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/meeting/request.hpp"
#include "discovery/registry/table.hpp"

namespace geminga::matching {

/// A subscription as it was until another one with its key took its place.
struct ReplacedSubscription {
  std::shared_ptr<const registry::SubscriptionEntry> entry;
  Request request;
  registry::Generation generation = registry::Generation::even;  ///< of the edition of the request
};

/// Files what comes and takes out what goes; judges nothing.
class Requests {
 public:
  explicit Requests(const Editions& editions) : editions_(editions) { open_index(editions.in_force()); }
  Requests(const Requests&) = delete;
  Requests& operator=(const Requests&) = delete;

  [[nodiscard]] const registry::Subscriptions& table() const { return table_; }
  /// registry::Table::share().
  void share(const std::shared_ptr<registry::SharedEntries>& entries) { table_.share(entries); }

  /// Adds an entry whose key is not there yet, with its request by the vocabulary in force.
  const registry::StoredSubscription& add(registry::SubscriptionEntry entry, Request request);
  /// Puts an entry with the same key into the place of one, and gives what was there.
  ReplacedSubscription replace(const registry::StoredSubscription& stored, registry::SubscriptionEntry entry,
                               Request request);
  /// Says that an entry was heard of again, as it is.
  void refresh(const registry::StoredSubscription& stored, base::Instant updated) { table_.refresh(stored, updated); }
  /// Marks an entry as about to be erased: it meets nothing.
  void retire(const registry::StoredSubscription& stored) { known(stored).is_leaving = true; }
  void erase(const registry::StoredSubscription& stored);

  /// Makes the index of an edition that has come, and drops that of one that goes.
  void open_index(const Edition& edition) { table_.set_class_count(index_size(edition), edition.generation); }
  void close_index(const Edition& edition) { table_.set_class_count(0, edition.generation); }
  /// Takes a subscription out of the index that it is in. From here on it is judged by the edition in force.
  void unfile(const registry::StoredSubscription& stored);
  /// Files an unfiled subscription by the edition in force, from whose vocabulary its request was made. Gives the
  /// former request.
  Request file(const registry::StoredSubscription& stored, Request request);

  /// Whether it is about to be erased.
  [[nodiscard]] bool is_going(const registry::StoredSubscription& stored) const { return known(stored).is_leaving; }
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
  /// The subscription in a slot, which must be in use.
  [[nodiscard]] const registry::StoredSubscription& at(std::uint32_t slot) const { return *known_[slot].stored; }
  /// Every slot is less than this.
  [[nodiscard]] std::size_t slots() const { return known_.size(); }
  /// The subscriptions that ask for what the provider's participant is.
  [[nodiscard]] const std::set<ServiceKey>& asking_on() const { return asking_on_; }

  /// How many entries were filed in an index since the start.
  [[nodiscard]] std::uint64_t filed() const { return filed_; }

 private:
  struct Known {
    const registry::StoredSubscription* stored = nullptr;
    std::shared_ptr<const Request> request;
    registry::Generation generation = registry::Generation::even;  ///< of the edition that it is judged by
    bool is_leaving = false;                                       ///< it is about to be erased
  };

  [[nodiscard]] Known& known(const registry::StoredSubscription& stored) { return known_[stored.slot]; }
  [[nodiscard]] const Known& known(const registry::StoredSubscription& stored) const { return known_[stored.slot]; }
  [[nodiscard]] FilingPlan plan(const registry::SubscriptionEntry& entry, const Request& request) const {
    return FilingPlan::of_subscription(request.classes, entry.subscription.weakest, editions_.in_force());
  }
  /// A request as it is kept: all that state nothing are one.
  [[nodiscard]] std::shared_ptr<const Request> kept(Request request) const;
  /// Converters that come or go make the subscription stale from here on, or do so no more.
  void watch(const registry::StoredSubscription& stored);
  void unwatch(const registry::StoredSubscription& stored);

  const Editions& editions_;
  const std::shared_ptr<const Request> plain_ = std::make_shared<const Request>(Request::plain());
  registry::Subscriptions table_;
  std::vector<Known> known_;  ///< by slot
  std::set<ServiceKey> asking_on_;
  std::uint64_t filed_ = 0;
};

}  // namespace geminga::matching

#endif
