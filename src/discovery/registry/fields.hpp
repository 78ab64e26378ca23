// Fields that the registry's templates read of entries of either kind.
#ifndef GEMINGA_DISCOVERY_REGISTRY_FIELDS_HPP
#define GEMINGA_DISCOVERY_REGISTRY_FIELDS_HPP

#include "discovery/registry/entry.hpp"

namespace geminga::registry {

inline const Identity& identity_of(const PublicationEntry& entry) { return entry.publication.identity; }
inline const Identity& identity_of(const SubscriptionEntry& entry) { return entry.subscription.identity; }

}  // namespace geminga::registry

#endif
