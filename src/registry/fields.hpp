// What the registry's templates need to know of an entry without knowing which kind it is.
#ifndef GEMINGA_REGISTRY_FIELDS_HPP
#define GEMINGA_REGISTRY_FIELDS_HPP

#include "registry/entry.hpp"

namespace geminga::registry {

inline const Identity& identity_of(const PublicationEntry& entry) { return entry.publication.identity; }
inline const Identity& identity_of(const SubscriptionEntry& entry) { return entry.subscription.identity; }
inline ChannelMode mode_of(const PublicationEntry& entry) { return entry.publication.mode; }
inline ChannelMode mode_of(const SubscriptionEntry& entry) { return entry.subscription.mode; }
inline const std::string& address_of(const PublicationEntry& entry) { return entry.publication.address; }
inline const std::string& address_of(const SubscriptionEntry& entry) { return entry.subscription.address; }

}  // namespace geminga::registry

#endif
