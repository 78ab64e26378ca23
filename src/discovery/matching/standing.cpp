// Tells from the choice itself who is chosen; the ranking alone does not know who was there first.
#include "discovery/matching/standing.hpp"

#include <algorithm>

#include "discovery/matching/state.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

std::optional<Standing> Matcher::State::standing(const StoredSubscription& subscription,
                                                 const StoredPublication& publication) {
  // While the vocabulary changes: its step is taken now, so that choice and ranking are by the same vocabulary.
  if (edition_of(subscription).generation != in_force_.generation) rematch(subscription);
  const auto ranked = match(subscription.entry, of_subscription_[subscription.slot].request);
  const auto at = std::ranges::find(ranked, &publication.entry, &Ranked::publication);
  if (at == ranked.end()) return std::nullopt;
  const std::size_t limit = counted_limit(subscription.entry);
  Place place{.rank = static_cast<std::size_t>(at - ranked.begin()) + 1, .candidates = ranked.size()};
  if (limit != 0 && place.rank > limit) place.last = ranked[limit - 1].publication;
  return standing(subscription, publication, place);
}

std::size_t Matcher::State::counted_limit(const registry::SubscriptionEntry& subscription) {
  return subscription.is_local ? limit_of(subscription) : subscription.subscription.limit;
}

Standing Matcher::State::standing(const StoredSubscription& subscription, const StoredPublication& publication,
                                  const Place& place) {
  if (edition_of(subscription).generation != in_force_.generation) rematch(subscription);
  Standing standing{.rank = place.rank, .candidates = place.candidates};
  const std::size_t limit = counted_limit(subscription.entry);
  const bool is_within = limit == 0 || standing.rank <= limit;
  standing.is_chosen = is_within;
  if (!is_within) standing.rival = place.last;
  if (limit == 0) return standing;
  if (!subscription.entry.is_local && !subscription.entry.subscription.chosen.empty()) {
    standing.decided = Standing::Decided::by_consumer;
    standing.is_chosen = is_announced_choice(subscription.entry, publication.entry);
    const auto* rival = publications_.find(subscription.entry.subscription.chosen.back());
    standing.rival = standing.is_chosen || rival == nullptr ? nullptr : &rival->entry;
    return standing;
  }
  if (!subscription.entry.is_local &&
      (limit_of(subscription.entry) == 0 || subscription.entry.subscription.mode == ChannelMode::one_to_many_stream)) {
    standing.decided = Standing::Decided::elsewhere;  // no choice of it is kept here
    return standing;
  }
  const Choice& choice = of_subscription_[subscription.slot].choice;
  const auto& considered_by = of_publication_[publication.slot].considered_by;
  const auto considered = considered_by.find(subscription.slot);
  standing.is_chosen = considered != considered_by.end() && choice.is_chosen(considered->second);
  standing.rival = nullptr;
  const auto chosen = choice.chosen();
  if (!standing.is_chosen && !chosen.empty()) standing.rival = &chosen.back().publication->entry;
  if (standing.is_chosen != is_within) standing.decided = Standing::Decided::by_incumbent;
  return standing;
}

}  // namespace geminga::matching
