// The choices that local subscriptions announce to the providers' hosts.
#ifndef GEMINGA_DISCOVERY_MATCHING_ANNOUNCED_CHOICES_HPP
#define GEMINGA_DISCOVERY_MATCHING_ANNOUNCED_CHOICES_HPP

#include <utility>
#include <vector>

#include "discovery/matching/arbitration/choice.hpp"
#include "discovery/registry/stored.hpp"

namespace geminga::matching {

/// A subscription announces what it is given where it has a limit of max_announced_choice at most, its providers are
/// told of it, and more may match than it admits, or one that matches cannot be reached from here: the providers' hosts
/// would choose among all.
class AnnouncedChoices {
 public:
  /// A local subscription was settled. `is_contested`: it had to choose. `is_other`: it or what it is given is not what
  /// it was.
  void update(const registry::StoredSubscription& subscription, const Choice& choice, bool is_contested, bool is_other);
  /// The subscription is about to be erased.
  void erase(const registry::StoredSubscription& subscription) {
    if (subscription.slot < of_subscription_.size()) of_subscription_[subscription.slot] = {};
  }

  /// In ascending order of key; nothing where nothing is announced.
  [[nodiscard]] std::vector<ServiceKey> keys(const registry::StoredSubscription& subscription) const {
    return subscription.slot < of_subscription_.size() ? of_subscription_[subscription.slot].keys
                                                       : std::vector<ServiceKey>();
  }
  /// Whether any of them has changed since the last call.
  [[nodiscard]] bool take_change() { return std::exchange(has_changed_, false); }

 private:
  struct Announced {
    bool is_contested = false;  ///< whether the subscription had to choose when it was settled
    std::vector<ServiceKey> keys;
  };

  std::vector<Announced> of_subscription_;  ///< by slot, up to the greatest of a local one
  bool has_changed_ = false;
};

}  // namespace geminga::matching

#endif
