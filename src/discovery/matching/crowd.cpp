// Bounds how many consumers of other hosts a publication of our own is told of.
#include "discovery/matching/state.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

bool Matcher::State::is_turned_away(const StoredSubscription& subscription, const StoredPublication& publication) {
  // Of a consumer with a limit only so many candidates are remembered, however many publications there are.
  const bool takes_all = !subscription.entry.is_local && limit_of(subscription.entry) == 0;
  if (!takes_all || of(publication).considered_by.size() < max_consumers) return false;
  crowded_.insert(publication.entry.key);
  return true;
}

void Matcher::State::relieve() {
  for (auto at = crowded_.begin(); at != crowded_.end();) {
    const StoredPublication* stored = publications_.find(*at);
    if (stored != nullptr && of(*stored).considered_by.size() > max_consumers / 2) {
      ++at;
      continue;
    }
    at = crowded_.erase(at);
    if (stored == nullptr) continue;
    for (const auto* subscription : subscriptions_for(*stored)) {
      judge(*subscription, *stored);
      settle(*subscription);
    }
  }
}

}  // namespace geminga::matching
