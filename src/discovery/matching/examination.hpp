// Findings about offers and requests, for queries: about one pair, and about an offer and many requests.
#ifndef GEMINGA_DISCOVERY_MATCHING_EXAMINATION_HPP
#define GEMINGA_DISCOVERY_MATCHING_EXAMINATION_HPP

#include <cstddef>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "discovery/matching/directory.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/judge.hpp"
#include "discovery/matching/obstacle.hpp"
#include "discovery/matching/preparation.hpp"

namespace geminga::matching {

/// Classes below that of an offer that are looked at for those who ask for something narrower.
inline constexpr std::size_t max_searched_classes = 256;

/// Gives false to stop.
using VisitFinding = std::function<bool(const registry::SubscriptionEntry&, const Finding&)>;

/// Changes nothing. The promises are those of the functions of Matcher with the same name.
class Examination {
 public:
  Examination(const Editions& editions, const Preparation& preparation, const Directory& directory, const Judge& judge)
      : editions_(editions), preparation_(preparation), directory_(directory), judge_(judge) {}

  [[nodiscard]] Finding examine(const registry::SubscriptionEntry& asked, const Request& request,
                                const registry::PublicationEntry& offered) const;
  bool examine_requests(const std::optional<ServiceKey>& after, const registry::PublicationEntry& offered,
                        const VisitFinding& visit) const;
  std::size_t examine_near(const registry::PublicationEntry& offered, std::size_t most,
                           const VisitFinding& visit) const;
  [[nodiscard]] std::expected<Match, std::string> why(const registry::SubscriptionEntry& asked,
                                                      const registry::PublicationEntry& offered,
                                                      const AskChain& chains) const;

 private:
  /// By the vocabulary in force, whatever the subscription is judged by.
  [[nodiscard]] Finding examine(const registry::StoredSubscription& stored, const Offer& offer) const;
  /// Adds, up to `most`, the subscriptions that ask for something below a class, the nearest first. Gives how many
  /// classes were looked at.
  std::size_t add_narrower(vocabulary::ClassNumber concept_class, std::size_t most,
                           std::vector<const registry::StoredSubscription*>& found) const;

  const Editions& editions_;
  const Preparation& preparation_;
  const Directory& directory_;
  const Judge& judge_;
};

}  // namespace geminga::matching

#endif
