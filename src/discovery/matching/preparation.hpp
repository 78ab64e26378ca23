// Makes requests of subscriptions by the vocabulary in force, and gives the classes of offers.
#ifndef GEMINGA_DISCOVERY_MATCHING_PREPARATION_HPP
#define GEMINGA_DISCOVERY_MATCHING_PREPARATION_HPP

#include <memory>
#include <utility>

#include "discovery/matching/editions.hpp"
#include "discovery/matching/meeting/request.hpp"

namespace geminga::matching {

/// Immutable. Requests borrow from it, so it must outlive them.
class Preparation {
 public:
  /// `placing`, `overlapping` and `comparing` as in Matcher; each may be empty.
  Preparation(const Editions& editions, Placing placing, Overlapping overlapping, Comparing comparing = {})
      : editions_(editions),
        placing_(std::move(placing)),
        overlapping_(std::move(overlapping)),
        comparing_(std::move(comparing)) {}
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  /// The request of a consumer. It takes part with converters where the subscription accepts a conversion.
  [[nodiscard]] Request prepare(const registry::SubscriptionEntry& entry) const;
  /// The same to explain what stands between it and an offer: converters always take part, so that it can be said what
  /// a conversion would cost.
  [[nodiscard]] Request prepare_to_explain(const registry::SubscriptionEntry& entry) const;
  /// The request of no known consumer; no converter takes part.
  [[nodiscard]] Request prepare(const Subscription& asked) const;

  /// The classes of an offer in a vocabulary, with the place of an expression.
  [[nodiscard]] Classes classes(const registry::PublicationEntry& entry,
                                const vocabulary::Vocabulary& vocabulary) const {
    return placed_classes(entry.publication.identity, vocabulary, placing_, entry.key.participant);
  }
  [[nodiscard]] const Placing& placing() const { return placing_; }

  /// Whether an offered concept overlaps with what is asked for, by the vocabulary in force, for a peer of this host;
  /// null: that waits to be decided.
  [[nodiscard]] OverlapAnswer overlap(const Meaning& offered, const Meaning& requested) const;
  /// The same about how an offered expression relates to a requested one.
  [[nodiscard]] ComparisonAnswer compare(const Meaning& offered, const Meaning& requested) const;

 private:
  [[nodiscard]] Request without_converters(const registry::SubscriptionEntry& entry) const;
  /// Asks the converters of the vocabulary in force for chains to this consumer.
  [[nodiscard]] AskChain chains_to(std::shared_ptr<const Consumer> consumer) const;

  const Editions& editions_;
  Placing placing_;
  Overlapping overlapping_;
  Comparing comparing_;
};

}  // namespace geminga::matching

#endif
