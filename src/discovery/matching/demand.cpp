// Whom an offer may concern: what stands between it and the subscriptions that are there.
#include <algorithm>

#include "discovery/matching/state.hpp"

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

Finding Matcher::State::examine(const StoredSubscription& stored, const Offer& offer) const {
  ++judged_;
  const SubscriptionEntry& asked = stored.entry;
  const bool is_apart = is_kept_apart(offer.entry.publication.identity, asked.subscription.identity);
  const bool is_current = edition_of(stored).generation == in_force_.generation;
  const Request& known = of_subscription_[stored.slot].request;
  const auto* requested = std::get_if<SemanticIdentity>(&asked.subscription.identity);
  const bool may_overlap = requested != nullptr && asked.subscription.weakest == Degree::overlapping && overlapping_;
  if (is_current && !may_overlap) return matching::examine(asked, known, offer, in_force_.vocabulary, is_apart);
  Request anew = is_current ? known : prepare(asked, false);
  if (may_overlap) {  // the question is that of who examines, and takes nothing of the share of who asks
    anew.overlaps = [this, requested, classes = anew.classes](const vocabulary::Vocabulary& vocabulary,
                                                              vocabulary::ClassNumber offered) {
      return overlapping_(vocabulary, offered, *requested, classes, {});
    };
  }
  return matching::examine(asked, anew, offer, in_force_.vocabulary, is_apart);
}

bool Matcher::State::examine_requests(const std::optional<ServiceKey>& after, const PublicationEntry& offered,
                                      const VisitFinding& visit) const {
  const Imagined imagined(offered, in_force_.vocabulary);
  return subscriptions_.visit_after(after, [&](const StoredSubscription& stored) {
    return is_going(stored) || visit(stored.entry, examine(stored, imagined.offer));
  });
}

std::size_t Matcher::State::examine_near(const PublicationEntry& offered, std::size_t most,
                                         const VisitFinding& visit) const {
  const auto* publication = publications_.find(offered.key);
  if (publication == nullptr) return 0;
  const Classes& known = classes(*publication, in_force_);
  std::vector<const StoredSubscription*> found;
  add_subscriptions_for(subscriptions_, *publication, known, in_force_, found);
  order_by_key(found);
  std::size_t searched = 0;
  if (known.concept_class && in_force_.vocabulary.is_satisfiable(*known.concept_class)) {
    searched = add_narrower(*known.concept_class, most, found);
  }
  if (found.size() > most) found.resize(most);
  for (const StoredSubscription* stored : found) {
    const bool goes_on = is_going(*stored) || visit(stored->entry, examine(*stored, offer(*publication, in_force_)));
    if (!goes_on) break;
  }
  return found.size() + searched;
}

std::size_t Matcher::State::add_narrower(vocabulary::ClassNumber concept_class, std::size_t most,
                                         std::vector<const StoredSubscription*>& found) const {
  const vocabulary::Vocabulary& vocabulary = in_force_.vocabulary;
  std::vector<vocabulary::ClassNumber> walked{concept_class};
  for (std::size_t i = 0; i < walked.size() && found.size() < most; ++i) {
    std::vector<vocabulary::ClassNumber> equal;
    if (i > 0) add_equivalents(vocabulary, walked[i], equal);
    for (const vocabulary::ClassNumber one : equal) {
      for (const auto& filed : subscriptions_.own(std::to_underlying(one), in_force_.generation)) {
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

std::optional<std::vector<ServiceKey>> Matcher::State::known_choice(const SubscriptionEntry& subscription) const {
  if (subscription.is_local) return chosen(subscription.key);
  if (!subscription.subscription.chosen.empty()) return subscription.subscription.chosen;
  if (limit_of(subscription) == 0 || subscription.subscription.mode == ChannelMode::one_to_many_stream) {
    return std::nullopt;
  }
  return chosen(subscription.key);
}

}  // namespace geminga::matching
