// One change of the matcher on its way from the directory through judging and choosing to the events.
#ifndef GEMINGA_DISCOVERY_MATCHING_CAUSE_HPP
#define GEMINGA_DISCOVERY_MATCHING_CAUSE_HPP

#include <memory>
#include <optional>
#include <utility>

#include "discovery/matching/directory.hpp"
#include "discovery/matching/event.hpp"

namespace geminga::matching {

/// Says what a put() has replaced and which consumer is not told. An empty cause is that of a change that replaces
/// nothing.
class Cause {
 public:
  struct PublicationBefore {
    const registry::StoredPublication* stored = nullptr;
    std::shared_ptr<const registry::PublicationEntry> before;
    bool is_silent = false;  ///< nothing changed that is told
  };
  struct SubscriptionBefore {
    const registry::StoredSubscription* stored = nullptr;
    ReplacedSubscription before;
    bool was_clashing = false;  ///< whether its number was that of two concepts
    bool is_silent = false;     ///< nothing changed that is told
  };

  /// Written out because GCC makes a defaulted one fill all members with zeros, which every put() would pay for.
  Cause() {}  // NOLINT(modernize-use-equals-default): as said above
  Cause(const Cause&) = delete;
  Cause& operator=(const Cause&) = delete;
  Cause(Cause&&) = default;
  Cause& operator=(Cause&&) = delete;

  /// Says what an entry was until it was replaced.
  void replace(const registry::StoredPublication& stored, std::shared_ptr<const registry::PublicationEntry> before) {
    const bool is_silent = is_told_alike(*before, stored.entry);
    publication_.emplace(&stored, std::move(before), is_silent);
  }
  void replace(const registry::StoredSubscription& stored, ReplacedSubscription&& before, bool was_clashing) {
    const bool is_silent = is_told_alike(*before.entry, stored.entry);
    subscription_.emplace(&stored, std::move(before), was_clashing, is_silent);
  }
  /// The subscription whose consumer gets no events; null: all consumers get them.
  const registry::StoredSubscription* untold = nullptr;

  /// The subscription that was replaced; null: none was.
  [[nodiscard]] const SubscriptionBefore* replaced_subscription() const {
    return subscription_ ? &*subscription_ : nullptr;
  }
  [[nodiscard]] bool replaces(const registry::StoredSubscription& stored) const {
    return subscription_ && subscription_->stored == &stored;
  }
  /// Whether the entry was replaced by one about which peers are told something else.
  [[nodiscard]] bool modifies(const registry::StoredPublication& stored) const {
    return publication_ && publication_->stored == &stored && !publication_->is_silent;
  }
  [[nodiscard]] bool modifies(const registry::StoredSubscription& stored) const {
    return replaces(stored) && !subscription_->is_silent;
  }
  /// The entry as its peers were told of it.
  [[nodiscard]] const std::shared_ptr<const registry::PublicationEntry>& as_told(
      const registry::StoredPublication& stored) const {
    return publication_ && publication_->stored == &stored ? publication_->before : stored.kept;
  }
  [[nodiscard]] const std::shared_ptr<const registry::SubscriptionEntry>& as_told(
      const registry::StoredSubscription& stored) const {
    return replaces(stored) ? subscription_->before.entry : stored.kept;
  }

 private:
  std::optional<PublicationBefore> publication_;
  std::optional<SubscriptionBefore> subscription_;
};

}  // namespace geminga::matching

#endif
