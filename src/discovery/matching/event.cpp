#include "discovery/matching/event.hpp"

#include <tuple>

namespace geminga::matching {

bool is_told_alike(const registry::PublicationEntry& one, const registry::PublicationEntry& other) {
  const auto told = [](const registry::PublicationEntry& entry) {
    const Publication& stated = entry.publication;
    return std::tie(entry.key, entry.peer_name, entry.participant_name, stated.mode, stated.identity, stated.address,
                    stated.port, stated.protocol, stated.priority, stated.attributes, entry.is_reachable);
  };
  return told(one) == told(other);
}

bool is_told_alike(const registry::SubscriptionEntry& one, const registry::SubscriptionEntry& other) {
  const auto told = [](const registry::SubscriptionEntry& entry) {
    const Subscription& stated = entry.subscription;
    return std::tie(entry.key, entry.peer_name, entry.participant_name, stated.mode, stated.identity, stated.address,
                    stated.port, stated.priority, stated.attributes, entry.is_reachable);
  };
  return told(one) == told(other);
}

}  // namespace geminga::matching
