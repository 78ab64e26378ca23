// A survey: a look at all offers, for one request. Which meet it, in which order, and which come nearest.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_SURVEY_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_SURVEY_HPP

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "discovery/matching/arbitration/rank.hpp"
#include "discovery/participant/knowledge/overlaps.hpp"
#include "discovery/participant/queries/reasons.hpp"

namespace geminga::participant {

/// The best offers that meet a request and that `why` tells of.
inline constexpr std::size_t max_told_matches = 4;
/// Offers that meet and are kept by their ranks. A request with a larger limit counts as one without a limit.
inline constexpr std::size_t max_ranked_matches = 1024;
/// Where no more offers than these may meet a request by its concept, they alone are ranked, at once. Else the whole
/// registry is walked, which can be interrupted.
inline constexpr std::size_t max_ranked_at_once = 256;

/// Walks the registry piece by piece, with one judgement an offer. The result does not depend on the pieces.
class Survey {
 public:
  /// A survey of all offers. Borrows both for its life.
  Survey(const matching::Matcher& matcher, const Overlaps& overlaps, Asked asked)
      : matcher_(matcher), overlaps_(overlaps), asked_(std::move(asked)) {}
  /// A survey of those that meet, for the place of an offer with this rank, which need not be in the registry.
  Survey(const matching::Matcher& matcher, const Overlaps& overlaps, Asked asked, matching::Rank offer);

  /// Whether all have been looked at.
  bool proceed(Piece& piece);

  [[nodiscard]] const Asked& asked() const { return asked_; }
  /// The number of offers that were looked at.
  [[nodiscard]] std::size_t seen() const { return seen_; }
  /// The number of those that meet the request.
  [[nodiscard]] std::size_t matching() const { return matching_; }
  /// The best of these, best first.
  [[nodiscard]] const std::set<matching::Rank, matching::BestFirst>& best() const { return best_; }
  /// The offers that come near without meeting.
  [[nodiscard]] const Nearest& nearest() const { return nearest_; }
  /// The number of offers that meet and rank ahead of the one whose place is asked for.
  [[nodiscard]] std::size_t ahead() const { return ahead_; }

 private:
  [[nodiscard]] bool is_comparable(const registry::PublicationEntry& offer) const;
  /// False where the offer waits for the reasoner, and is to be looked at again.
  bool look(const registry::PublicationEntry& offer);
  void take(const matching::Rank& rank);

  const matching::Matcher& matcher_;
  const Overlaps& overlaps_;
  Asked asked_;
  std::optional<matching::Rank> offer_;
  std::optional<std::vector<ServiceKey>> candidates_;  ///< nothing: everything is walked
  std::optional<ServiceKey> last_;
  std::size_t seen_ = 0;
  std::size_t matching_ = 0;
  std::size_t ahead_ = 0;
  std::set<matching::Rank, matching::BestFirst> best_;
  Nearest nearest_;
};

}  // namespace geminga::participant

#endif
