// A look at everything that is offered, for one request: what meets it in which order, and what comes nearest.
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

/// How many offers `why` tells of that meet a request, and how many that do not: the best and the nearest.
inline constexpr std::size_t max_told_matches = 4;
inline constexpr std::size_t max_told_misfits = 4;
/// How many of those that meet are kept by their ranks. A request that asks for more counts as one that asks for all.
inline constexpr std::size_t max_ranked_matches = 1024;
/// Where no more than these may meet a request by its concept, they alone are ranked, at once; else the whole registry
/// is walked, which can be interrupted.
inline constexpr std::size_t max_ranked_at_once = 256;

/// Walks the registry piece by piece, one judgement an offer. Which pieces it takes changes nothing about what it
/// finds.
class Survey {
 public:
  /// Of everything, for what meets and what comes near.
  Survey(const matching::Matcher& matcher, const Overlaps& overlaps, Asked asked)
      : matcher_(matcher), overlaps_(overlaps), asked_(std::move(asked)) {}
  /// Of what meets alone, for the place of an offer with this rank; it need not be in the registry.
  Survey(const matching::Matcher& matcher, const Overlaps& overlaps, Asked asked, matching::Rank offer);

  /// Whether all have been looked at.
  bool proceed(Piece& piece);

  [[nodiscard]] const Asked& asked() const { return asked_; }
  /// How many were looked at.
  [[nodiscard]] std::size_t seen() const { return seen_; }
  /// How many meet the request.
  [[nodiscard]] std::size_t matching() const { return matching_; }
  /// The best of them, best first.
  [[nodiscard]] const std::set<matching::Rank, matching::BestFirst>& best() const { return best_; }
  /// The nearest of those that do not and whose concept fits at least, or whose text nearly.
  [[nodiscard]] const std::set<Misfit>& misfits() const { return misfits_; }
  [[nodiscard]] const Nearest& nearest() const { return nearest_; }
  /// How many of them rank ahead of the one whose place is asked for.
  [[nodiscard]] std::size_t ahead() const { return ahead_; }

 private:
  /// False: it waits for the reasoner, and is to be looked at again.
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
  std::set<Misfit> misfits_;
  Nearest nearest_;
};

}  // namespace geminga::participant

#endif
