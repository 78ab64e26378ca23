// Publications and subscriptions as the registry keeps them: the statement, its peer, and when it was last heard.
#ifndef GEMINGA_DISCOVERY_REGISTRY_ENTRY_HPP
#define GEMINGA_DISCOVERY_REGISTRY_ENTRY_HPP

#include <string>

#include "base/time.hpp"
#include "geminga/service.hpp"

namespace geminga::registry {

/// A publication with its provenance. Its address is one that consumers of this host can reach.
struct PublicationEntry {
  ServiceKey key;
  Publication publication;
  std::string peer_name;
  std::string participant_name;
  bool is_local = false;  ///< offered by a peer of this very participant
  /// When it was last stated. The neighbour table knows when it was last affirmed and when it expires. A table keeps
  /// this beside the entry (Stored::updated), so that equal entries of several tables can be one.
  base::Instant updated;
  /// False where its address is that of a participant that cannot be reached from this host.
  bool is_reachable = true;
  /// Whether the two are equal for consumers. Times do not count.
  [[nodiscard]] bool same_as(const PublicationEntry& other) const {
    return key == other.key && publication == other.publication && peer_name == other.peer_name &&
           participant_name == other.participant_name && is_reachable == other.is_reachable;
  }
};

struct SubscriptionEntry {
  ServiceKey key;
  Subscription subscription;
  std::string peer_name;
  std::string participant_name;
  bool is_local = false;
  base::Instant updated;
  bool is_reachable = true;
  [[nodiscard]] bool same_as(const SubscriptionEntry& other) const {
    return key == other.key && subscription == other.subscription && peer_name == other.peer_name &&
           participant_name == other.participant_name && is_reachable == other.is_reachable;
  }
};

}  // namespace geminga::registry

#endif
