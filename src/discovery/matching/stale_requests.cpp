#include "discovery/matching/stale_requests.hpp"

namespace geminga::matching {

bool StaleRequests::is_empty() const {
  const auto& other = editions_.other().converters;
  return editions_.in_force().converters->stale().empty() && (other == nullptr || other->stale().empty());
}

void StaleRequests::judge(const registry::StoredSubscription& subscription) {
  if (!directory_.edition_of(subscription).converters->stale().contains(subscription.entry.key)) return;
  Cause cause;
  pairs_.settle(subscription, cause);
}

bool StaleRequests::judge_next() {
  if (is_empty()) return false;
  Converters& converters = editions_.in_force().converters->stale().empty() ? *editions_.other().converters
                                                                            : *editions_.in_force().converters;
  const ServiceKey key = *converters.stale().begin();
  if (const auto* stored = directory_.subscriptions().find(key)) {
    judge(*stored);
  } else {
    converters.refresh(key);
  }
  return true;
}

void StaleRequests::judge_some() {
  for (std::size_t count = 0; count < max_rejudged_at_once && judge_next(); ++count) {
  }
}

}  // namespace geminga::matching
