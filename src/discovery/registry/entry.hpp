// A publication or subscription as the registry keeps it: what was stated, by whom, and when it was last heard.
#ifndef GEMINGA_DISCOVERY_REGISTRY_ENTRY_HPP
#define GEMINGA_DISCOVERY_REGISTRY_ENTRY_HPP

#include <string>

#include "base/time.hpp"
#include "geminga/service.hpp"

namespace geminga::registry {

/// The stated part and its provenance. `address` of the publication is one that works for consumers of this host.
struct PublicationEntry {
  ServiceKey key;
  Publication publication;
  std::string peer_name;
  std::string participant_name;
  bool is_local = false;  ///< offered by a peer of this very participant
  base::Instant
      updated;  ///< last said; when it was affirmed since then, and when it expires, the neighbour table knows
  /// Whether a consumer would see a difference; provenance times do not count.
  [[nodiscard]] bool same_as(const PublicationEntry& other) const {
    return key == other.key && publication == other.publication && peer_name == other.peer_name &&
           participant_name == other.participant_name;
  }
};

struct SubscriptionEntry {
  ServiceKey key;
  Subscription subscription;
  std::string peer_name;
  std::string participant_name;
  bool is_local = false;
  base::Instant updated;
  [[nodiscard]] bool same_as(const SubscriptionEntry& other) const {
    return key == other.key && subscription == other.subscription && peer_name == other.peer_name &&
           participant_name == other.participant_name;
  }
};

}  // namespace geminga::registry

#endif
