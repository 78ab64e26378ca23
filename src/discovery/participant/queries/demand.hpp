// A demand: a look at all requests, for one offer. Which take it, which have better ones, and which come nearest.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_DEMAND_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_DEMAND_HPP

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "discovery/participant/queries/sides.hpp"
#include "discovery/participant/queries/survey.hpp"

namespace geminga::participant {

/// Requests whose choice is not known here and for which the offers are ranked, to say whether this one is among the
/// best. Further ones count as not taking it.
inline constexpr std::size_t max_ranked_requests = 64;

/// Walks all subscriptions piece by piece, with one judgement each, then the offers for those whose choice is not
/// known.
class Demand {
 public:
  /// Borrows both for its life.
  Demand(const matching::Matcher& matcher, const Overlaps& overlaps, Offered offer)
      : matcher_(matcher), overlaps_(overlaps), offer_(std::move(offer)) {}

  /// Whether all have been looked at.
  bool proceed(Piece& piece);

  [[nodiscard]] const Offered& offer() const { return offer_; }
  /// The offer as it is compared with this request: in its mode where it has none.
  [[nodiscard]] registry::PublicationEntry offer_for(const registry::SubscriptionEntry& request) const;
  /// The number of requests that were looked at, of those that the offer meets, and of those that take it.
  [[nodiscard]] std::size_t seen() const { return seen_; }
  [[nodiscard]] std::size_t matching() const { return matching_; }
  [[nodiscard]] std::size_t taken() const { return taken_; }
  /// The first few by key.
  [[nodiscard]] const std::vector<ServiceKey>& takers() const { return takers_; }
  /// The first few of those that it meets and that have better ones.
  [[nodiscard]] const std::vector<ServiceKey>& others() const { return others_; }
  /// The requests that come near without meeting.
  [[nodiscard]] const Nearest& nearest() const { return nearest_; }

 private:
  enum class Taking : std::uint8_t { yes, no, unknown };

  void look(const registry::SubscriptionEntry& request, matching::Finding finding);
  [[nodiscard]] Taking taking(const registry::SubscriptionEntry& request, const matching::Match& match) const;
  void note(const ServiceKey& request, bool is_taken);

  const matching::Matcher& matcher_;
  const Overlaps& overlaps_;
  Offered offer_;
  std::optional<ServiceKey> last_;
  bool is_walked_ = false;
  std::size_t seen_ = 0;
  std::size_t matching_ = 0;
  std::size_t taken_ = 0;
  std::vector<ServiceKey> takers_;
  std::vector<ServiceKey> others_;
  std::vector<ServiceKey> undecided_;  ///< the last is next
  std::optional<Survey> survey_;       ///< for the last of them
  Nearest nearest_;
};

/// The rank of an offer that meets a request. One that nobody offers ranks behind all others that are as good.
[[nodiscard]] matching::Rank rank_of(const Asked& asked, const Offered& offer, const matching::Match& match);

}  // namespace geminga::participant

#endif
