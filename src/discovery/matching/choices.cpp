#include "discovery/matching/choices.hpp"

#include "discovery/matching/degrees/representation.hpp"
#include "discovery/matching/interest.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

namespace {

/// The place comes from a ranking, which does not know the incumbents.
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
    const auto* rival = directory.offers().table().find(announced.back());
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

}  // namespace

std::vector<ServiceKey> Choices::chosen(const ServiceKey& subscription) const {
  std::vector<ServiceKey> keys;
  const StoredSubscription* stored = directory_.requests().table().find(subscription);
  if (stored == nullptr) return keys;
  for (const auto& one : pairs_.choice(*stored).chosen()) keys.push_back(one.publication->entry.key);
  return keys;
}

std::vector<ServiceKey> Choices::consumers(const ServiceKey& publication) const {
  std::vector<ServiceKey> keys;
  const StoredPublication* stored = directory_.offers().table().find(publication);
  if (stored == nullptr || !is_provider_told(stored->entry.publication.mode)) return keys;
  for (const auto& [slot, rank] : pairs_.considered_by(*stored)) {
    const StoredSubscription& one = directory_.requests().at(slot);
    if (pairs_.choice(one).is_chosen(rank)) keys.push_back(one.entry.key);
  }
  return keys;
}

std::optional<Match> Choices::given(const ServiceKey& subscription, const ServiceKey& publication) const {
  const StoredSubscription* asks = directory_.requests().table().find(subscription);
  const StoredPublication* offers = directory_.offers().table().find(publication);
  return asks == nullptr || offers == nullptr ? std::nullopt : pairs_.chosen_match(*asks, *offers);
}

std::vector<ServiceKey> Choices::announced(const ServiceKey& subscription) const {
  const StoredSubscription* stored = directory_.requests().table().find(subscription);
  return stored == nullptr ? std::vector<ServiceKey>() : pairs_.announced().keys(*stored);
}

std::optional<Standing> Choices::standing(const ServiceKey& subscription, const ServiceKey& publication,
                                          const Place& place) const {
  const StoredSubscription* asked = directory_.requests().table().find(subscription);
  const StoredPublication* offered = directory_.offers().table().find(publication);
  if (asked == nullptr || offered == nullptr) return std::nullopt;
  return standing_of(*asked, *offered, place, directory_, pairs_);
}

std::shared_ptr<const vocabulary::Chain> Choices::chain(const ServiceKey& subscription,
                                                        const ServiceKey& publication) const {
  const StoredSubscription* asked = directory_.requests().table().find(subscription);
  const StoredPublication* offered = directory_.offers().table().find(publication);
  return asked == nullptr || offered == nullptr ? nullptr : directory_.chain(*asked, *offered);
}

std::string Choices::chain_words(const ServiceKey& subscription, const vocabulary::Chain& chain) const {
  const StoredSubscription* asked = directory_.requests().table().find(subscription);
  return asked == nullptr ? "" : matching::chain_words(&chain, directory_.requests().edition_of(*asked).vocabulary);
}

std::optional<std::vector<ServiceKey>> Choices::known(const SubscriptionEntry& subscription) const {
  const auto& announced = subscription.subscription.chosen;
  if (!subscription.is_local && !announced.empty()) return announced;
  return is_chosen_here(subscription) ? std::optional(chosen(subscription.key)) : std::nullopt;
}

}  // namespace geminga::matching
