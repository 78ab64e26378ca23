#include "discovery/matching/announced_choices.hpp"

#include <algorithm>

#include "identity/service_limits.hpp"

namespace geminga::matching {

void AnnouncedChoices::update(const registry::StoredSubscription& subscription, const Choice& choice, bool is_contested,
                              bool is_other) {
  if (subscription.slot >= of_subscription_.size()) of_subscription_.resize(subscription.slot + 1);
  Announced& announced = of_subscription_[subscription.slot];
  const bool was_contested = std::exchange(announced.is_contested, is_contested);
  if (!is_other && was_contested == announced.is_contested) return;
  const Subscription& asked = subscription.entry.subscription;
  const bool is_told = asked.limit != 0 && is_provider_told(asked.mode);
  std::vector<ServiceKey> keys;
  if (is_told && asked.limit <= max_announced_choice && announced.is_contested) {
    for (const auto& one : choice.chosen()) keys.push_back(one.publication->entry.key);
    std::ranges::sort(keys);
  }
  if (keys == announced.keys) return;
  announced.keys = std::move(keys);
  has_changed_ = true;
}

}  // namespace geminga::matching
