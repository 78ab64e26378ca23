#include "discovery/matching/judge.hpp"

namespace geminga::matching {

Judgement Judge::judge(const registry::SubscriptionEntry& asked, const Request& request,
                       const registry::StoredPublication& publication, const Edition& edition) const {
  if (is_kept_apart(publication.entry.publication.identity, asked.subscription.identity)) return {};
  return judgement_of(asked, request, described(directory_.offers().offer(publication, edition), request, edition),
                      edition.vocabulary);
}

Finding Judge::examine(const registry::SubscriptionEntry& asked, const Request& request, const Offer& offer,
                       const Edition& edition) const {
  const bool is_apart = is_kept_apart(offer.entry.publication.identity, asked.subscription.identity);
  return matching::examine(asked, request, described(offer, request, edition), edition.vocabulary, is_apart);
}

Offer Judge::described(Offer offer, const Request& request, const Edition& edition) const {
  if (!request.on) return offer;
  const auto* description = directory_.offers().table().find(description_key(offer.entry.key.participant));
  if (description == nullptr || directory_.offers().is_going(*description)) return offer;
  offer.described_as = std::get_if<SemanticIdentity>(&description->entry.publication.identity);
  offer.described_classes = &directory_.offers().classes(*description, edition);
  return offer;
}

}  // namespace geminga::matching
