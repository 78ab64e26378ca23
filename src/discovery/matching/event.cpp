// The words of GCNP for events, and what of an entry they tell.
#include "discovery/matching/event.hpp"

#include <tuple>

#include "base/assert.hpp"

namespace geminga::matching {

std::string_view to_string(Reason reason) {
  switch (reason) {
    case Reason::withdrawn:
      return "withdrawn";
    case Reason::expired:
      return "expired";
    case Reason::left:
      return "left";
    case Reason::outranked:
      return "outranked";
    case Reason::changed:
      return "changed";
    case Reason::renamed:
      return "renamed";
  }
  base::assertion_failed("a reason has a word", __FILE__, __LINE__);
}

bool is_told_alike(const registry::PublicationEntry& one, const registry::PublicationEntry& other) {
  const auto told = [](const registry::PublicationEntry& entry) {
    const Publication& stated = entry.publication;
    return std::tie(entry.key, entry.peer_name, entry.participant_name, stated.mode, stated.identity, stated.address,
                    stated.port, stated.protocol, stated.priority, stated.attributes);
  };
  return told(one) == told(other);
}

bool is_told_alike(const registry::SubscriptionEntry& one, const registry::SubscriptionEntry& other) {
  const auto told = [](const registry::SubscriptionEntry& entry) {
    const Subscription& stated = entry.subscription;
    return std::tie(entry.key, entry.peer_name, entry.participant_name, stated.mode, stated.identity, stated.address,
                    stated.port, stated.priority, stated.attributes);
  };
  return told(one) == told(other);
}

}  // namespace geminga::matching
