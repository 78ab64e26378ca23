#include "discovery/matching/interest.hpp"

#include <algorithm>

namespace geminga::matching {

using registry::PublicationEntry;
using registry::SubscriptionEntry;

std::uint32_t arbitrated_limit(const SubscriptionEntry& subscription) {
  const std::uint32_t limit = subscription.subscription.limit;
  if (subscription.is_local) return limit == 0 ? max_given : std::min(limit, max_given);
  if (!subscription.subscription.chosen.empty()) return 0;  // nothing is left to choose
  return limit <= max_counted_providers ? limit : 0;
}

std::size_t counted_limit(const SubscriptionEntry& subscription) {
  return subscription.is_local ? arbitrated_limit(subscription) : subscription.subscription.limit;
}

bool is_chosen_here(const SubscriptionEntry& subscription) {
  return subscription.is_local ||
         (arbitrated_limit(subscription) != 0 && is_provider_told(subscription.subscription.mode));
}

bool is_of_interest(const SubscriptionEntry& subscription, const PublicationEntry& publication) {
  if (subscription.is_local) return true;
  if (!is_provider_told(subscription.subscription.mode)) return false;
  if (!subscription.subscription.chosen.empty()) {
    return publication.is_local && is_announced_choice(subscription, publication);
  }
  // Without a limit no candidate stands in the way of another.
  return publication.is_local || arbitrated_limit(subscription) != 0;
}

bool is_announced_choice(const SubscriptionEntry& subscription, const PublicationEntry& publication) {
  return std::ranges::binary_search(subscription.subscription.chosen, publication.key);
}

}  // namespace geminga::matching
