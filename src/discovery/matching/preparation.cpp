#include "discovery/matching/preparation.hpp"

#include <memory>
#include <utility>

namespace geminga::matching {

Request Preparation::prepare(const Subscription& asked) const {
  return prepared(asked, editions_.in_force().vocabulary, placing_, {}, overlapping_, comparing_);
}

Request Preparation::without_converters(const registry::SubscriptionEntry& entry) const {
  return prepared(entry.subscription, editions_.in_force().vocabulary, placing_, entry.key.participant, overlapping_,
                  comparing_);
}

AskChain Preparation::chains_to(std::shared_ptr<const Consumer> consumer) const {
  return [converters = editions_.in_force().converters, consumer = std::move(consumer)](
             vocabulary::ClassNumber offered, vocabulary::ClassNumber requested) {
    return converters->chain(*consumer, offered, requested);
  };
}

Request Preparation::prepare(const registry::SubscriptionEntry& entry) const {
  Request request = without_converters(entry);
  if (!request.classes.representation_class || entry.subscription.convert == 0) return request;
  request.consumer = std::make_shared<const Consumer>(
      Consumer{.entry = entry, .scope = request.scope, .declared = editions_.in_force().vocabulary.units()});
  request.asks.chains = chains_to(request.consumer);
  return request;
}

Request Preparation::prepare_to_explain(const registry::SubscriptionEntry& entry) const {
  Request request = without_converters(entry);
  if (!request.classes.representation_class) return request;
  const vocabulary::Units& declared = editions_.in_force().vocabulary.units();
  request.consumer =
      std::make_shared<const Consumer>(Consumer{.entry = entry, .scope = request.scope, .declared = declared});
  request.asks.chains = chains_to(request.consumer);
  registry::SubscriptionEntry of_all = entry;
  of_all.subscription.providers.clear();
  of_all.subscription.protocols.clear();
  request.chains_of_all =
      chains_to(std::make_shared<const Consumer>(Consumer{.entry = of_all, .scope = Scope(), .declared = declared}));
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
