#include "discovery/matching/examination.hpp"

#include <utility>
#include <variant>

#include "discovery/matching/meeting/explained.hpp"

namespace geminga::matching {

using registry::PublicationEntry;
using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

std::shared_ptr<const Request> Examination::prepare(const SubscriptionEntry& asked) const {
  return std::make_shared<const Request>(preparation_.prepare_to_explain(asked));
}

std::shared_ptr<const Request> Examination::prepare(const Subscription& asked) const {
  return std::make_shared<const Request>(preparation_.prepare(asked));
}

std::optional<Match> Examination::meets(const SubscriptionEntry& asked, const Request& request,
                                        const PublicationEntry& publication) const {
  const StoredPublication* stored = directory_.offers().table().find(publication.key);
  if (stored == nullptr || directory_.offers().is_going(*stored)) return std::nullopt;
  return judge_.judge(asked, request, *stored, editions_.in_force()).match;
}

Finding Examination::examine(const SubscriptionEntry& asked, const Request& request,
                             const PublicationEntry& offered) const {
  const Edition& edition = editions_.in_force();
  const auto* stored = directory_.offers().table().find(offered.key);
  if (stored != nullptr && &stored->entry == &offered) {
    return judge_.examine(asked, request, directory_.offers().offer(*stored, edition), edition);
  }
  return judge_.examine(asked, request, Imagined(offered, edition.vocabulary, preparation_.placing()).offer, edition);
}

Finding Examination::examine(const StoredSubscription& stored, const Offer& offer) const {
  const SubscriptionEntry& asked = stored.entry;
  const Edition& edition = editions_.in_force();
  const bool is_current = directory_.requests().edition_of(stored).generation == edition.generation;
  const Request& known = directory_.requests().request(stored);
  const auto* requested = std::get_if<SemanticIdentity>(&asked.subscription.identity);
  const bool may_overlap = requested != nullptr && asked.subscription.weakest == Degree::overlapping;
  const bool may_compare = offer.classes.place && has_expression(asked.subscription.identity);
  const bool may_compare_on = known.on && known.on->compares;
  if (is_current && !may_overlap && !may_compare && !may_compare_on) {
    return judge_.examine(asked, known, offer, edition);
  }
  Request anew = is_current ? known : preparation_.prepare(asked);
  // Questions are those of the peer that examines, and take nothing of the consumer's share.
  if (may_overlap) {
    anew.asks.overlaps = [this, requested, classes = anew.classes](const vocabulary::Vocabulary&,
                                                                   const Meaning& offered) {
      return preparation_.overlap(offered, {*requested, classes});
    };
  }
  const auto comparing = [this](const SemanticIdentity& wanted, const Classes& wanted_classes) -> AskComparison {
    return [this, wanted, wanted_classes](const vocabulary::Vocabulary&, const Meaning& offered) {
      return preparation_.compare(offered, {wanted, wanted_classes});
    };
  };
  if (may_compare && anew.classes.place) anew.asks.compares = comparing(*requested, anew.classes);
  if (anew.on && anew.on->compares) anew.on->compares = comparing(anew.on->identity, anew.on->classes);
  return judge_.examine(asked, anew, offer, edition);
}

std::expected<Match, std::string> Examination::why(const SubscriptionEntry& asked, const PublicationEntry& offered,
                                                   const AskChain& chains) const {
  if (judge_.is_kept_apart(offered.publication.identity, asked.subscription.identity)) {
    return std::unexpected(
        "identity: the number is that of two different services, and connects neither with whoever states the number");
  }
  const Imagined imagined(offered, vocabulary(), preparation_.placing());
  Request prepared = preparation_.prepare_to_explain(asked);
  if (chains) prepared.asks.chains = chains;
  return explained(asked, prepared, imagined.offer, vocabulary());
}

}  // namespace geminga::matching
