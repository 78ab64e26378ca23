// Events: what local peers are told of services and consumers.
#ifndef GEMINGA_DISCOVERY_MATCHING_EVENT_HPP
#define GEMINGA_DISCOVERY_MATCHING_EVENT_HPP

#include <memory>
#include <variant>

#include "discovery/matching/arbitration/reason.hpp"
#include "discovery/matching/degrees/degree.hpp"
#include "discovery/registry/entry.hpp"
#include "geminga/event.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// An event of a local peer. `to` is its own subscription where `about` is a publication, or its own publication where
/// `about` is a subscription.
struct Event {
  Change change = Change::add;
  ServiceKey to;
  /// The entry as it is now; for del as the peer was last told of it. Never null. Events of one cause share it.
  std::variant<std::shared_ptr<const registry::PublicationEntry>, std::shared_ptr<const registry::SubscriptionEntry>>
      about;
  Match match;                        ///< for del as it was last told
  Reason reason = Reason::withdrawn;  ///< for del only
  /// The conversion of a service's representation; null: it is not converted, or for del.
  std::shared_ptr<const vocabulary::Chain> chain{};
};

/// Whether events about the two entries say the same. Keys by which only hosts judge are not told: those of a
/// publication that limit its consumers, and those of a subscription that limit and rank its providers.
[[nodiscard]] bool is_told_alike(const registry::PublicationEntry& one, const registry::PublicationEntry& other);
[[nodiscard]] bool is_told_alike(const registry::SubscriptionEntry& one, const registry::SubscriptionEntry& other);

}  // namespace geminga::matching

#endif
