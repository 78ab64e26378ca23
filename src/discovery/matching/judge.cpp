#include "discovery/matching/judge.hpp"

namespace geminga::matching {

Judgement Judge::judge(const registry::SubscriptionEntry& asked, const Request& request,
                       const registry::StoredPublication& publication, const Edition& edition) const {
  if (is_kept_apart(publication.entry.publication.identity, asked.subscription.identity)) return {};
  return judgement_of(asked, request, directory_.offer(publication, edition), edition.vocabulary);
}

Finding Judge::examine(const registry::SubscriptionEntry& asked, const Request& request, const Offer& offer,
                       const Edition& edition) const {
  const bool is_apart = is_kept_apart(offer.entry.publication.identity, asked.subscription.identity);
  return matching::examine(asked, request, offer, edition.vocabulary, is_apart);
}

}  // namespace geminga::matching
