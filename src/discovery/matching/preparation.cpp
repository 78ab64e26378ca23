#include "discovery/matching/preparation.hpp"

#include <memory>

namespace geminga::matching {

Request Preparation::prepare(const Subscription& asked) const {
  return prepared(asked, editions_.in_force().vocabulary, placing_, {}, overlapping_, comparing_);
}

Request Preparation::prepare(const registry::SubscriptionEntry& entry, bool must_convert) const {
  const Edition& edition = editions_.in_force();
  Request request =
      prepared(entry.subscription, edition.vocabulary, placing_, entry.key.participant, overlapping_, comparing_);
  if (!request.classes.representation_class || (!must_convert && entry.subscription.convert == 0)) return request;
  const auto asking = [&](std::shared_ptr<const Consumer> consumer) -> AskChain {
    return [converters = edition.converters, consumer = std::move(consumer)](vocabulary::ClassNumber offered,
                                                                             vocabulary::ClassNumber requested) {
      return converters->chain(*consumer, offered, requested);
    };
  };
  const vocabulary::Units& declared = edition.vocabulary.units();
  request.consumer =
      std::make_shared<const Consumer>(Consumer{.entry = entry, .scope = request.scope, .declared = declared});
  request.asks.chains = asking(request.consumer);
  if (!must_convert) return request;
  registry::SubscriptionEntry of_all = entry;
  of_all.subscription.providers.clear();
  of_all.subscription.protocols.clear();
  request.chains_of_all =
      asking(std::make_shared<const Consumer>(Consumer{.entry = of_all, .scope = Scope(), .declared = declared}));
  return request;
}

OverlapAnswer Preparation::overlap(const Meaning& offered, const Meaning& requested) const {
  const vocabulary::Vocabulary& vocabulary = editions_.in_force().vocabulary;
  return overlapping_ ? overlapping_(vocabulary, offered, requested, {})
                      : decided_at_once(vocabulary, offered, requested);
}

ComparisonAnswer Preparation::compare(const Meaning& offered, const Meaning& requested) const {
  const vocabulary::Vocabulary& vocabulary = editions_.in_force().vocabulary;
  return comparing_ ? comparing_(vocabulary, offered, requested, {}) : compared_at_once(vocabulary, offered, requested);
}

}  // namespace geminga::matching
