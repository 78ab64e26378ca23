// How one offer and one request meet, by the vocabulary in force.
#ifndef GEMINGA_DISCOVERY_MATCHING_EXAMINATION_HPP
#define GEMINGA_DISCOVERY_MATCHING_EXAMINATION_HPP

#include <cstddef>
#include <expected>
#include <memory>
#include <optional>
#include <string>

#include "discovery/matching/directory.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/judge.hpp"
#include "discovery/matching/preparation.hpp"

namespace geminga::matching {

/// Either side may be one that nobody has stated. Changes nothing.
class Examination {
 public:
  Examination(const Editions& editions, const Preparation& preparation, const Directory& directory, const Judge& judge)
      : editions_(editions), preparation_(preparation), directory_(directory), judge_(judge) {}

  [[nodiscard]] const vocabulary::Vocabulary& vocabulary() const { return editions_.vocabulary(); }
  /// The request for the functions below, valid while the ontology stays. Without a consumer nothing is converted for
  /// it.
  [[nodiscard]] std::shared_ptr<const Request> prepare(const Subscription& asked) const;
  [[nodiscard]] std::shared_ptr<const Request> prepare(const registry::SubscriptionEntry& asked) const;
  /// The classes of an offer, with the place of an expression.
  [[nodiscard]] Classes classes(const registry::PublicationEntry& offered) const {
    return preparation_.classes(offered, vocabulary());
  }
  /// Whether what an offer is can have instances in common with what a request asks for, for a peer of our own; null:
  /// that waits to be decided. Something must be known of both.
  [[nodiscard]] OverlapAnswer overlap(const Meaning& offered, const Meaning& requested) const {
    return preparation_.overlap(offered, requested);
  }
  /// How many converters take no part in chains because their hosts have as many as may.
  [[nodiscard]] std::size_t waiting_converters() const { return editions_.in_force().converters->waiting_count(); }

  /// How a publication of the registry meets `asked`, from which `request` was prepared; its mode and its identity may
  /// have been set to the publication's own since.
  [[nodiscard]] std::optional<Match> meets(const registry::SubscriptionEntry& asked, const Request& request,
                                           const registry::PublicationEntry& publication) const;
  /// The finding about an offer and `asked`, from which `request` was prepared.
  [[nodiscard]] Finding examine(const registry::SubscriptionEntry& asked, const Request& request,
                                const registry::PublicationEntry& offered) const;
  /// The same of a subscription of the registry, whatever vocabulary it is judged by.
  [[nodiscard]] Finding examine(const registry::StoredSubscription& stored, const Offer& offer) const;
  /// How this offer meets this request; the error says in words what does not fit. `chains` says what is converted;
  /// empty: what this very request is told.
  [[nodiscard]] std::expected<Match, std::string> why(const registry::SubscriptionEntry& asked,
                                                      const registry::PublicationEntry& offered,
                                                      const AskChain& chains = {}) const;

 private:
  const Editions& editions_;
  const Preparation& preparation_;
  const Directory& directory_;
  const Judge& judge_;
};

}  // namespace geminga::matching

#endif
