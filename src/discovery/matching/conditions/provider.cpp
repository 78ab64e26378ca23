#include "discovery/matching/conditions/provider.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/text.hpp"

namespace geminga::matching {

using registry::PublicationEntry;

bool is_of(const ProviderFilter& provider, const PublicationEntry& publication) {
  const bool is_participant = provider.participant.empty() ||
                              participant_id(provider.participant) == publication.key.participant ||
                              provider.participant == publication.participant_name;
  const bool is_peer = provider.peer.empty() ||
                       base::parse_number<std::uint32_t>(provider.peer) == std::to_underlying(publication.key.peer) ||
                       provider.peer == publication.peer_name;
  return is_participant && is_peer;
}

bool is_accepted_provider(const Subscription& subscription, const PublicationEntry& publication) {
  return subscription.providers.empty() || std::ranges::any_of(subscription.providers, [&](const auto& provider) {
           return is_of(provider, publication);
         });
}

bool is_accepted_protocol(const Subscription& subscription, const PublicationEntry& publication) {
  return subscription.protocols.empty() ||
         std::ranges::find(subscription.protocols, publication.publication.protocol) != subscription.protocols.end();
}

}  // namespace geminga::matching
