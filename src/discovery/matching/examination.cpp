#include "discovery/matching/examination.hpp"

#include <algorithm>
#include <utility>

#include "discovery/matching/explained.hpp"

namespace geminga::matching {

using registry::PublicationEntry;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

namespace {

/// Adds the classes that are equivalent to this one, itself included.
void add_equivalents(const vocabulary::Vocabulary& vocabulary, vocabulary::ClassNumber number,
                     std::vector<vocabulary::ClassNumber>& classes) {
  for (const vocabulary::ClassNumber one : vocabulary.subsumers(number)) {
    if (vocabulary.is_subsumed(one, number)) classes.push_back(one);
  }
}

}  // namespace

Finding Examination::examine(const SubscriptionEntry& asked, const Request& request,
                             const PublicationEntry& offered) const {
  const Edition& edition = editions_.in_force();
  const auto* stored = directory_.publications().find(offered.key);
  if (stored != nullptr && &stored->entry == &offered) {
    return judge_.examine(asked, request, directory_.offer(*stored, edition), edition);
  }
  return judge_.examine(asked, request, Imagined(offered, edition.vocabulary, preparation_.placing()).offer, edition);
}

Finding Examination::examine(const StoredSubscription& stored, const Offer& offer) const {
  const SubscriptionEntry& asked = stored.entry;
  const Edition& edition = editions_.in_force();
  const bool is_current = directory_.edition_of(stored).generation == edition.generation;
  const Request& known = directory_.request(stored);
  const auto* requested = std::get_if<SemanticIdentity>(&asked.subscription.identity);
  const bool may_overlap = requested != nullptr && asked.subscription.weakest == Degree::overlapping;
  const bool may_compare = offer.classes.place && has_expression(asked.subscription.identity);
  const bool may_compare_on = known.on && known.on->compares;
  if (is_current && !may_overlap && !may_compare && !may_compare_on) {
    return judge_.examine(asked, known, offer, edition);
  }
  Request anew = is_current ? known : preparation_.prepare(asked, false);
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

bool Examination::examine_requests(const std::optional<ServiceKey>& after, const PublicationEntry& offered,
                                   const VisitFinding& visit) const {
  const Imagined imagined(offered, editions_.in_force().vocabulary, preparation_.placing());
  return directory_.subscriptions().visit_after(after, [&](const StoredSubscription& stored) {
    return directory_.is_going(stored) || visit(stored.entry, examine(stored, imagined.offer));
  });
}

std::size_t Examination::examine_near(const PublicationEntry& offered, std::size_t most,
                                      const VisitFinding& visit) const {
  const auto* publication = directory_.publications().find(offered.key);
  if (publication == nullptr) return 0;
  const Edition& edition = editions_.in_force();
  const Classes& known = directory_.classes(*publication, edition);
  std::vector<const StoredSubscription*> found;
  add_subscriptions_for(directory_.subscriptions(), *publication, known, edition, found);
  order_by_key(found);
  std::size_t searched = 0;
  if (known.concept_class && edition.vocabulary.is_satisfiable(*known.concept_class)) {
    searched = add_narrower(*known.concept_class, most, found);
  }
  if (found.size() > most) found.resize(most);
  const Offer offer = directory_.offer(*publication, edition);
  for (const StoredSubscription* stored : found) {
    if (!directory_.is_going(*stored) && !visit(stored->entry, examine(*stored, offer))) break;
  }
  return found.size() + searched;
}

std::size_t Examination::add_narrower(vocabulary::ClassNumber concept_class, std::size_t most,
                                      std::vector<const StoredSubscription*>& found) const {
  const Edition& edition = editions_.in_force();
  const vocabulary::Vocabulary& vocabulary = edition.vocabulary;
  std::vector<vocabulary::ClassNumber> walked{concept_class};
  for (std::size_t i = 0; i < walked.size() && found.size() < most; ++i) {
    std::vector<vocabulary::ClassNumber> equal;
    if (i > 0) add_equivalents(vocabulary, walked[i], equal);
    for (const vocabulary::ClassNumber one : equal) {
      for (const auto& filed : directory_.subscriptions().own(std::to_underlying(one), edition.generation)) {
        if (std::ranges::find(found, filed.stored) == found.end()) found.push_back(filed.stored);
        if (found.size() >= most) break;
      }
    }
    for (const vocabulary::ClassNumber child : vocabulary.children(walked[i])) {
      if (walked.size() >= max_searched_classes) break;
      if (std::ranges::find(walked, child) == walked.end()) walked.push_back(child);
    }
  }
  return walked.size();
}

std::expected<Match, std::string> Examination::why(const SubscriptionEntry& asked, const PublicationEntry& offered,
                                                   const AskChain& chains) const {
  if (judge_.is_kept_apart(offered.publication.identity, asked.subscription.identity)) {
    return std::unexpected(
        "identity: the number is that of two different services, and connects neither with whoever states the number");
  }
  const vocabulary::Vocabulary& vocabulary = editions_.in_force().vocabulary;
  const Imagined imagined(offered, vocabulary, preparation_.placing());
  Request prepared = preparation_.prepare(asked, true);
  if (chains) prepared.asks.chains = chains;
  return explained(asked, prepared, imagined.offer, vocabulary);
}

}  // namespace geminga::matching
