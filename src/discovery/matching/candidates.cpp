#include "discovery/matching/candidates.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace geminga::matching {

FilingPlan::FilingPlan(std::optional<vocabulary::ClassNumber> own, const Edition& edition)
    : generation_(edition.generation) {
  if (own) own_ = std::to_underlying(*own);
}

FilingPlan::FilingPlan(const vocabulary::Place& place, const Edition& edition) : generation_(edition.generation) {
  if (place.equivalent) {
    own_ = std::to_underlying(*place.equivalent);
  } else {
    for (const vocabulary::ClassNumber child : place.children) further_own_.push_back(std::to_underlying(child));
    further_own_.push_back(bucket_of_expressions(edition));
  }
}

void FilingPlan::file_below(const std::vector<vocabulary::ClassNumber>& subsumers) {
  for (const vocabulary::ClassNumber number : subsumers) below_.push_back(std::to_underlying(number));
}

FilingPlan FilingPlan::of_publication(const Classes& classes, const Edition& edition) {
  if (classes.place) {
    FilingPlan plan(classes.place->equivalent, edition);
    if (!classes.place->equivalent) plan.own_ = bucket_of_expressions(edition);
    plan.file_below(edition.vocabulary.subsumers(*classes.place));
    return plan;
  }
  FilingPlan plan(classes.concept_class, edition);
  if (classes.concept_class) plan.file_below(edition.vocabulary.subsumers(*classes.concept_class));
  return plan;
}

FilingPlan FilingPlan::of_subscription(const Classes& classes, Degree weakest, const Edition& edition) {
  if (has_meaning(classes) && weakest == Degree::overlapping) return {edition.vocabulary.thing(), edition};
  if (classes.place) {
    FilingPlan plan(*classes.place, edition);
    if (accepts_broader(weakest)) plan.file_below(edition.vocabulary.subsumers(*classes.place));
    return plan;
  }
  FilingPlan plan(classes.concept_class, edition);
  if (classes.concept_class && accepts_broader(weakest))
    plan.file_below(edition.vocabulary.subsumers(*classes.concept_class));
  return plan;
}

void add_subscriptions_for(const registry::Subscriptions& subscriptions, const registry::StoredPublication& offer,
                           const Classes& classes, const Edition& edition,
                           std::vector<const registry::StoredSubscription*>& found) {
  const auto add_all = [&found](auto filed) {
    for (const auto& one : filed) found.push_back(one.stored);
  };
  const Identity& offered = offer.entry.publication.identity;
  const auto* semantic = std::get_if<SemanticIdentity>(&offered);
  if (semantic != nullptr) add_all(subscriptions.with_identity(NumericIdentity{offer.identity}, offer.identity));
  if (std::holds_alternative<NumericIdentity>(offered)) {
    std::ranges::for_each(subscriptions.with_number(offer.identity), add_all);
  } else if (semantic == nullptr) {
    add_all(subscriptions.with_identity(offered, offer.identity));
  } else if (!has_meaning(classes)) {
    add_all(subscriptions.with_concept(semantic->concept_iri));
  } else {
    for (const registry::ClassedAt& filed : offer.classes[std::to_underlying(edition.generation)]) {
      if (filed.is_below()) add_all(subscriptions.own(filed.number(), edition.generation));
    }
    // Those that accept what is broader: they ask for a class below the offer, or for an expression.
    const auto add_below = [&](vocabulary::ClassNumber number) {
      add_all(subscriptions.below(std::to_underlying(number), edition.generation));
    };
    if (classes.concept_class) {
      add_below(*classes.concept_class);
    } else if (classes.place->equivalent) {
      add_below(*classes.place->equivalent);
    } else {
      std::ranges::for_each(classes.place->children, add_below);
      add_all(subscriptions.own(bucket_of_expressions(edition), edition.generation));
    }
  }
}

void order_by_key(std::vector<const registry::StoredSubscription*>& subscriptions) {
  std::ranges::sort(subscriptions, {}, [](const auto* stored) { return stored->entry.key; });
  const auto twice = std::ranges::unique(subscriptions);
  subscriptions.erase(twice.begin(), twice.end());
}

}  // namespace geminga::matching
