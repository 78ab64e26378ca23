// The search for all that may meet an offer or a request, among what is known of the team.
#ifndef GEMINGA_DISCOVERY_MATCHING_SEARCH_HPP
#define GEMINGA_DISCOVERY_MATCHING_SEARCH_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "discovery/matching/directory.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/examination.hpp"
#include "discovery/matching/judge.hpp"
#include "discovery/matching/preparation.hpp"

namespace geminga::matching {

/// Classes below that of an offer that are looked at for those who ask for something narrower.
inline constexpr std::size_t max_searched_classes = 256;

/// Gives false to stop.
using VisitFinding = std::function<bool(const registry::SubscriptionEntry&, const Finding&)>;

/// Goes through the registry by the vocabulary in force. Changes nothing.
class Search {
 public:
  Search(const Editions& editions, const Preparation& preparation, const Directory& directory, const Judge& judge,
         const Examination& examination)
      : editions_(editions),
        preparation_(preparation),
        directory_(directory),
        judge_(judge),
        examination_(examination) {}

  /// The publications whose identity may meet that of `asked`, from which `request` was prepared, in no particular
  /// order; nothing where they are more than `most`.
  [[nodiscard]] std::optional<std::vector<ServiceKey>> candidates(const Subscription& asked, const Request& request,
                                                                  std::size_t most) const;
  /// Up to `most` of them: the first that are found.
  [[nodiscard]] std::vector<ServiceKey> some_candidates(const Subscription& asked, const Request& request,
                                                        std::size_t most) const;
  /// Gives `visit` the finding about an offer, which may be one that nobody has stated, and each subscription behind
  /// `after`, or all, in ascending order of key, until it gives false. Whether all were visited.
  bool examine_requests(const std::optional<ServiceKey>& after, const registry::PublicationEntry& offered,
                        const VisitFinding& visit) const;
  /// Gives `visit` the finding about an offer that is known and up to `most` subscriptions that are likely to come
  /// near: first those that ask for the same or something above it, then for something below it, the nearest first.
  /// Gives how many subscriptions and classes were looked at.
  std::size_t examine_near(const registry::PublicationEntry& offered, std::size_t most,
                           const VisitFinding& visit) const;
  /// Whether anybody in the team serves this subscription, or asks for this publication, which must be known.
  [[nodiscard]] bool is_served(const registry::SubscriptionEntry& subscription) const;
  [[nodiscard]] bool is_used(const registry::PublicationEntry& publication) const;
  /// The converters that the chain of a known request needs, as Chain::via names them (conversions/converter.hpp).
  /// Looks at all that the requests that convert may meet.
  [[nodiscard]] std::set<std::string> converters_in_use() const;

 private:
  /// Adds, up to `most`, the subscriptions that ask for something below a class, the nearest first. Gives how many
  /// classes were looked at.
  std::size_t add_narrower(vocabulary::ClassNumber concept_class, std::size_t most,
                           std::vector<const registry::StoredSubscription*>& found) const;

  const Editions& editions_;
  const Preparation& preparation_;
  const Directory& directory_;
  const Judge& judge_;
  const Examination& examination_;
};

}  // namespace geminga::matching

#endif
