#include "discovery/matching/directory.hpp"

#include "discovery/matching/degrees/representation.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

std::shared_ptr<const vocabulary::Chain> Directory::chain(const StoredSubscription& subscription,
                                                          const StoredPublication& publication) const {
  const Edition& edition = requests_.edition_of(subscription);
  const Request& asked = requests_.request(subscription);
  return chain_between(offers_.classes(publication, edition).representation_class, asked.classes.representation_class,
                       edition.vocabulary, asked.asks.chains);
}

std::vector<const StoredSubscription*> Directory::subscriptions_found_for(const StoredPublication& publication) const {
  std::vector<const StoredSubscription*> found;
  const auto add = [&](const Edition& edition) {
    add_subscriptions_for(requests_.table(), publication, offers_.classes(publication, edition), edition, found);
  };
  add(editions_.in_force());
  if (editions_.stage() == ChangeStage::rematching) add(editions_.other());
  return found;
}

std::vector<const StoredSubscription*> Directory::subscriptions_for(const StoredPublication& publication) const {
  auto found = subscriptions_found_for(publication);
  order_by_key(found);
  return found;
}

}  // namespace geminga::matching
