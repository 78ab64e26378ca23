#include "discovery/matching/standing.hpp"

#include <algorithm>
#include <vector>

#include "discovery/matching/directory.hpp"
#include "discovery/matching/interest.hpp"
#include "discovery/matching/judge.hpp"
#include "discovery/matching/pairs.hpp"

namespace geminga::matching {
namespace {

using registry::StoredPublication;
using registry::StoredSubscription;

/// A publication that meets a request.
struct Ranked {
  const registry::PublicationEntry* publication = nullptr;
  Rank rank;
};

}  // namespace

std::optional<Place> ranked_place(const StoredSubscription& subscription, const StoredPublication& publication,
                                  const Directory& directory, const Judge& judge, const Edition& edition) {
  const Request& request = directory.request(subscription);
  std::vector<Ranked> ranked;
  directory.visit_publications_for(subscription.entry.subscription, request, [&](const StoredPublication& candidate) {
    if (directory.is_going(candidate)) return false;
    const auto match = judge.judge(subscription.entry, request, candidate, edition).match;
    if (match) ranked.push_back({&candidate.entry, request.rank(candidate.entry, *match)});
    return false;
  });
  std::ranges::sort(ranked, BestFirst{}, &Ranked::rank);
  const auto at = std::ranges::find(ranked, &publication.entry, &Ranked::publication);
  if (at == ranked.end()) return std::nullopt;
  const std::size_t limit = counted_limit(subscription.entry);
  Place place{.rank = static_cast<std::size_t>(at - ranked.begin()) + 1, .candidates = ranked.size()};
  if (limit != 0 && place.rank > limit) place.last = ranked[limit - 1].publication;
  return place;
}

Standing standing_of(const StoredSubscription& subscription, const StoredPublication& publication, const Place& place,
                     const Directory& directory, const Pairs& pairs) {
  Standing standing{.rank = place.rank, .candidates = place.candidates};
  const std::size_t limit = counted_limit(subscription.entry);
  const bool is_within = limit == 0 || standing.rank <= limit;
  standing.is_chosen = is_within;
  if (!is_within) standing.rival = place.last;
  if (limit == 0) return standing;
  const auto& announced = subscription.entry.subscription.chosen;
  if (!subscription.entry.is_local && !announced.empty()) {
    standing.decided = Standing::Decided::by_consumer;
    standing.is_chosen = is_announced_choice(subscription.entry, publication.entry);
    const auto* rival = directory.publications().find(announced.back());
    standing.rival = standing.is_chosen || rival == nullptr ? nullptr : &rival->entry;
    return standing;
  }
  if (!is_chosen_here(subscription.entry)) {
    standing.decided = Standing::Decided::elsewhere;
    return standing;
  }
  standing.is_chosen = pairs.chosen_match(subscription, publication).has_value();
  standing.rival = nullptr;
  const auto chosen = pairs.choice(subscription).chosen();
  if (!standing.is_chosen && !chosen.empty()) standing.rival = &chosen.back().publication->entry;
  if (standing.is_chosen != is_within) standing.decided = Standing::Decided::by_incumbent;
  return standing;
}

}  // namespace geminga::matching
