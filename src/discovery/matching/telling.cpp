// From verdicts to events: who is told, of what, in which order.

#include <algorithm>
#include <utility>

#include "discovery/matching/state.hpp"
#include "identity/service_limits.hpp"

namespace geminga::matching {

using registry::PublicationEntry;
using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

void Matcher::State::settle(const StoredSubscription& subscription) {
  if (!edition_of(subscription).converters->stale().empty()) rejudge(subscription);
  const Verdict verdict = of(subscription).choice.settle([&] { refill(subscription); });
  forget_dropped(subscription);
  const auto tell_gone = [&](const Verdict::Gone& gone) {
    tell_consumer(Change::del, subscription, *gone.publication, gone.told, gone.reason);
    tell_provider(Change::del, subscription, *gone.publication, gone.told, gone.reason);
  };
  for (const auto& gone : verdict.gone) tell_gone(gone);
  for (const auto& kept : verdict.kept) {
    const bool is_other_match = kept.told != kept.match;
    const bool is_other_publication = replaced_publication_.stored == kept.publication && !replaced_is_silent_;
    const bool is_other_subscription = replaced_subscription_.stored == &subscription && !replaced_is_silent_;
    if (is_other_match || is_other_publication) {
      tell_consumer(Change::modify, subscription, *kept.publication, kept.match);
    }
    // It is told what it gives, and not how that is converted.
    const bool is_other_gift = kept.told.degree != kept.match.degree || kept.told.distance != kept.match.distance;
    if (is_other_gift || is_other_subscription) {
      tell_provider(Change::modify, subscription, *kept.publication, kept.match);
    }
  }
  for (const auto& come : verdict.come) {
    tell_consumer(Change::add, subscription, *come.publication, come.match);
    tell_provider(Change::add, subscription, *come.publication, come.match);
  }
  // Last, so that a consumer has the better one before the worse one goes, and is never without.
  for (const auto& gone : verdict.outranked) tell_gone(gone);
  if (!subscription.entry.is_local) return;
  auto& known = of(subscription);
  const bool was_contested = std::exchange(known.is_contested, known.choice.is_contested());
  const bool is_same = verdict.gone.empty() && verdict.come.empty() && verdict.outranked.empty() &&
                       was_contested == known.is_contested && replaced_subscription_.stored != &subscription;
  if (!is_same) note_choice(subscription);
}

void Matcher::State::note_choice(const StoredSubscription& subscription) {
  const Subscription& asked = subscription.entry.subscription;
  auto& known = of(subscription);
  std::vector<ServiceKey> choice;
  const bool is_told = asked.limit != 0 && asked.mode != ChannelMode::one_to_many_stream;
  if (is_told && asked.limit <= max_announced_choice && known.is_contested) {
    for (const auto& one : known.choice.chosen()) choice.push_back(one.publication->entry.key);
    std::ranges::sort(choice);
  }
  if (choice == known.announced_choice) return;
  known.announced_choice = std::move(choice);
  has_choice_changed_ = true;
}

void Matcher::State::tell_consumer(Change change, const StoredSubscription& subscription,
                                   const StoredPublication& publication, Match match, Reason reason) {
  if (!subscription.entry.is_local || untold_ == &subscription) return;
  const PublicationEntry& about = change == Change::del ? as_told(publication) : publication.entry;
  auto chain = change == Change::del || match.cost == 0 ? nullptr : chain_of(subscription, publication);
  events_.push_back(
      {change, subscription.entry.key, snapshot(told_publication_, about), match, reason, std::move(chain)});
}

void Matcher::State::tell_provider(Change change, const StoredSubscription& subscription,
                                   const StoredPublication& publication, Match match, Reason reason) {
  if (!publication.entry.is_local || of(publication).leaves) return;
  const bool is_over = change == Change::del;
  const ChannelMode mode = is_over ? as_told(publication).publication.mode : publication.entry.publication.mode;
  if (mode == ChannelMode::one_to_many_stream) return;
  const SubscriptionEntry& about = is_over ? as_told(subscription) : subscription.entry;
  events_.push_back({change, publication.entry.key, snapshot(told_subscription_, about), match, reason, {}});
}

std::vector<ServiceKey> Matcher::State::chosen(const ServiceKey& subscription) const {
  std::vector<ServiceKey> keys;
  const StoredSubscription* stored = subscriptions_.find(subscription);
  if (stored == nullptr) return keys;
  for (const auto& one : of_subscription_[stored->slot].choice.chosen()) keys.push_back(one.publication->entry.key);
  return keys;
}

std::vector<ServiceKey> Matcher::State::consumers(const ServiceKey& publication) const {
  std::vector<ServiceKey> keys;
  const StoredPublication* stored = publications_.find(publication);
  if (stored == nullptr || stored->entry.publication.mode == ChannelMode::one_to_many_stream) return keys;
  for (const auto& [slot, rank] : of_publication_[stored->slot].considered_by) {
    const OfSubscription& one = of_subscription_[slot];
    if (one.choice.is_chosen(rank)) keys.push_back(one.stored->entry.key);
  }
  return keys;
}

std::optional<Match> Matcher::State::given(const ServiceKey& subscription, const ServiceKey& publication) const {
  const StoredSubscription* asks = subscriptions_.find(subscription);
  const StoredPublication* offers = publications_.find(publication);
  if (asks == nullptr || offers == nullptr) return std::nullopt;
  const auto& considered_by = of_publication_[offers->slot].considered_by;
  const auto known = considered_by.find(asks->slot);
  if (known == considered_by.end() || !of_subscription_[asks->slot].choice.is_chosen(known->second))
    return std::nullopt;
  return known->second.match;
}

const PublicationEntry& Matcher::State::as_told(const StoredPublication& publication) const {
  return replaced_publication_.stored == &publication ? replaced_publication_.before : publication.entry;
}

const SubscriptionEntry& Matcher::State::as_told(const StoredSubscription& subscription) const {
  return replaced_subscription_.stored == &subscription ? replaced_subscription_.before : subscription.entry;
}

}  // namespace geminga::matching
