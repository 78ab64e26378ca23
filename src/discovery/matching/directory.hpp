// Offers and requests side by side: which of one kind may meet one of the other.
#ifndef GEMINGA_DISCOVERY_MATCHING_DIRECTORY_HPP
#define GEMINGA_DISCOVERY_MATCHING_DIRECTORY_HPP

#include <memory>
#include <vector>

#include "discovery/matching/candidates.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/offers.hpp"
#include "discovery/matching/preparation.hpp"
#include "discovery/matching/requests.hpp"

namespace geminga::matching {

/// Owns both, and looks up across them.
class Directory {
 public:
  Directory(const Editions& editions, const Preparation& preparation)
      : editions_(editions), offers_(editions, preparation), requests_(editions) {}
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;

  [[nodiscard]] Offers& offers() { return offers_; }
  [[nodiscard]] const Offers& offers() const { return offers_; }
  [[nodiscard]] Requests& requests() { return requests_; }
  [[nodiscard]] const Requests& requests() const { return requests_; }

  /// How a publication is turned into what a subscription asks for; null where it is not.
  [[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain(const registry::StoredSubscription& subscription,
                                                               const registry::StoredPublication& publication) const;
  /// The subscriptions that a publication may meet, each once, in ascending order of key.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> subscriptions_for(
      const registry::StoredPublication& publication) const;
  /// The same in no particular order, and perhaps more than once. Looks at none of them.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> subscriptions_found_for(
      const registry::StoredPublication& publication) const;
  /// Calls `visit` once for each publication that a subscription may meet, those that are about to be erased included.
  /// `visit` gives true to stop.
  template <typename Visit>
  void visit_publications_for(const registry::StoredSubscription& subscription, const Visit& visit) const {
    const Subscription& asked = subscription.entry.subscription;
    visit_publications(offers_.table(), asked.identity, requests_.request(subscription).classes, asked.weakest,
                       requests_.edition_of(subscription), visit);
  }
  /// The same of a subscription that need not be known, from which `request` was made by the vocabulary in force.
  template <typename Visit>
  void visit_publications_for(const Subscription& asked, const Request& request, const Visit& visit) const {
    visit_publications(offers_.table(), asked.identity, request.classes, asked.weakest, editions_.in_force(), visit);
  }

 private:
  const Editions& editions_;
  Offers offers_;
  Requests requests_;
};

}  // namespace geminga::matching

#endif
