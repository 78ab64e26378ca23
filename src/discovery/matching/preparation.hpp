// Makes requests of subscriptions by the vocabulary in force.
#ifndef GEMINGA_DISCOVERY_MATCHING_PREPARATION_HPP
#define GEMINGA_DISCOVERY_MATCHING_PREPARATION_HPP

#include <utility>

#include "discovery/matching/editions.hpp"
#include "discovery/matching/request.hpp"

namespace geminga::matching {

/// Immutable. Requests borrow from it, so it must outlive them.
class Preparation {
 public:
  /// `placing` and `overlapping` as in Matcher; both may be empty.
  Preparation(const Editions& editions, Placing placing, Overlapping overlapping)
      : editions_(editions), placing_(std::move(placing)), overlapping_(std::move(overlapping)) {}
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  /// The request of a consumer that takes part with converters. `must_convert`: also where the subscription accepts no
  /// conversion, to say what one would cost.
  [[nodiscard]] Request prepare(const registry::SubscriptionEntry& entry, bool must_convert) const;
  /// The request of nobody in particular: nobody converts for it.
  [[nodiscard]] Request prepare(const Subscription& asked) const;

  /// Whether an offered class overlaps with what is asked for, by the vocabulary in force, for a peer of this host;
  /// null: that waits to be decided.
  [[nodiscard]] OverlapAnswer overlap(vocabulary::ClassNumber offered, const SemanticIdentity& requested,
                                      const Classes& requested_classes) const;

 private:
  const Editions& editions_;
  Placing placing_;
  Overlapping overlapping_;
};

}  // namespace geminga::matching

#endif
