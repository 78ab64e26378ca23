// Changes to the registry, the pairs that they concern, and what they lead to.
#include "discovery/matching/state.hpp"

#include <algorithm>
#include <utility>

#include "discovery/matching/converter.hpp"

namespace geminga::matching {

using registry::PublicationEntry;
using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

std::optional<Match> Matcher::State::meets(const StoredSubscription& subscription,
                                           const StoredPublication& publication) const {
  const Edition& edition = edition_of(subscription);
  if (of_publication_[publication.slot].leaves || of_subscription_[subscription.slot].is_leaving) return std::nullopt;
  return meet(subscription.entry, of_subscription_[subscription.slot].request, publication, edition);
}

std::optional<Match> Matcher::State::meets(const SubscriptionEntry& asked, const Request& request,
                                           const PublicationEntry& publication) const {
  const StoredPublication* stored = publications_.find(publication.key);
  if (stored == nullptr || of_publication_[stored->slot].leaves) return std::nullopt;
  return meet(asked, request, *stored, in_force_);
}

std::optional<Match> Matcher::State::meet(const SubscriptionEntry& asked, const Request& request,
                                          const StoredPublication& offered, const Edition& edition) const {
  ++judged_;
  if (is_kept_apart(offered.entry.publication.identity, asked.subscription.identity)) return std::nullopt;
  return matching::meets(asked, request, offer(offered, edition), edition.vocabulary);
}

Finding Matcher::State::examine(const SubscriptionEntry& asked, const Request& request,
                                const PublicationEntry& offered) const {
  ++judged_;
  const bool is_apart = is_kept_apart(offered.publication.identity, asked.subscription.identity);
  const StoredPublication* stored = publications_.find(offered.key);
  if (stored != nullptr && &stored->entry == &offered) {
    return matching::examine(asked, request, offer(*stored, in_force_), in_force_.vocabulary, is_apart);
  }
  const Imagined imagined(offered, in_force_.vocabulary);
  return matching::examine(asked, request, imagined.offer, in_force_.vocabulary, is_apart);
}

void Matcher::State::file(const StoredPublication& stored, const Edition& edition) {
  auto& known = of(stored).classes[std::to_underlying(edition.generation)];
  known = classes_of(stored.entry.publication.identity, edition.vocabulary);
  const Attributes& attributes = stored.entry.publication.attributes;
  of(stored).signatures[std::to_underlying(edition.generation)] =
      has_signature(attributes) ? std::make_unique<const Signature>(signature_of(attributes, edition.vocabulary))
                                : nullptr;
  if (!of(stored).leaves && (is_converter(attributes) || !edition.converters->is_empty())) {
    edition.converters->put(stored.entry, audience(stored), of(stored).arrival);
    filed_ += edition.converters->take_work();
  }
  const FilingPlan plan = FilingPlan::of_publication(known, edition);
  publications_.refile(stored, plan.filing());
  filed_ += 1 + plan.size();
}

const StoredPublication& Matcher::State::store(PublicationEntry entry, const StoredPublication* known) {
  const registry::Filing nowhere;
  if (known == nullptr) {
    known = &publications_.insert(std::move(entry), nowhere);
    if (known->slot >= of_publication_.size()) of_publication_.resize(known->slot + 1);
    of(*known) = {};
    of(*known).arrival = ++arrivals_;
  } else {
    replaced_is_silent_ = is_told_alike(known->entry, entry);
    replaced_publication_ = {known, known->entry};
    publications_.replace(*known, std::move(entry), nowhere);
  }
  const Publication& offered = known->entry.publication;
  of(*known).audience =
      Audience::is_stated(offered) ? std::make_unique<const Audience>(Audience::of(offered)) : nullptr;
  file(*known, in_force_);
  if (is_known_by_both()) file(*known, other_);
  return *known;
}

void Matcher::State::release_if_others(const StoredSubscription& subscription, const Preferences& preferences) {
  if (of(subscription).request.preferences == preferences) return;
  of(subscription).choice.release_waiting();
  forget_dropped(subscription);
}

const StoredSubscription& Matcher::State::store(SubscriptionEntry entry, const StoredSubscription* known) {
  Request request = prepare(entry, false);
  const FilingPlan plan = FilingPlan::of_subscription(request.classes, entry.subscription.weakest, in_force_);
  if (known == nullptr) {
    known = &subscriptions_.insert(std::move(entry), plan.filing());
    if (known->slot >= of_subscription_.size()) of_subscription_.resize(known->slot + 1);
    of(*known) = {};
    of(*known).stored = known;
  } else {
    replaced_is_silent_ = is_told_alike(known->entry, entry);
    replaced_subscription_ = {known, known->entry};
    unwatch(*known);
    release_if_others(*known, request.preferences);
    replaced_request_ = std::move(of(*known).request);
    replaced_generation_ = of(*known).generation;
    replaced_was_clashing_ = clashing_.contains(known->identity);
    subscriptions_.replace(*known, std::move(entry), plan.filing());
  }
  of(*known).choice.set_margins(request.preferences.margins());
  of(*known).choice.set_limit(limit_of(known->entry));
  of(*known).request = std::move(request);
  of(*known).is_waiting = false;
  of(*known).generation = in_force_.generation;
  watch(*known);
  return *known;
}

void Matcher::State::put(PublicationEntry entry) {
  const StoredPublication* known = publications_.find(entry.key);
  if (known != nullptr && of(*known).leaves) {
    finish_departures();
    known = nullptr;
  }
  begin_cause();
  if (known != nullptr && known->entry.is_local != entry.is_local) {
    remove({known}, {}, Reason::changed);
    known = nullptr;
  }
  if (known != nullptr && known->entry.same_as(entry)) {
    publications_.refresh(*known, entry.updated);
    return;
  }
  const Id32 number_before = known == nullptr ? id32(entry.publication.identity) : known->identity;
  const bool is_new_identity = known == nullptr || known->entry.publication.identity != entry.publication.identity;
  const StoredPublication& stored = store(std::move(entry), known);
  auto anew = review(stored.identity, is_new_identity);
  if (number_before != stored.identity) {
    const auto further = review(number_before, false);
    anew.insert(anew.end(), further.begin(), further.end());
  }
  auto concerned = subscriptions_for(stored);
  for (const auto& [slot, rank] : of(stored).considered_by) concerned.push_back(of_subscription_[slot].stored);
  order_by_key(concerned);
  for (const auto* subscription : concerned) {
    if (std::ranges::find(anew, subscription) != anew.end()) continue;
    judge(*subscription, stored);
    settle(*subscription);
  }
  judge_anew(anew);
  replaced_publication_ = {};
  relieve();
  if (has_stale()) rejudge_some();
}

void Matcher::State::put(SubscriptionEntry entry, Telling telling) {
  const StoredSubscription* known = subscriptions_.find(entry.key);
  if (known != nullptr && of(*known).is_leaving) {
    finish_departures();
    known = nullptr;
  }
  begin_cause();
  if (known != nullptr && known->entry.is_local != entry.is_local) {
    remove({}, {known}, Reason::changed);
    known = nullptr;
  }
  if (known != nullptr && known->entry.same_as(entry)) {
    subscriptions_.refresh(*known, entry.updated);
    return;
  }
  const Id32 number_before = known == nullptr ? id32(entry.subscription.identity) : known->identity;
  const bool is_new_identity = known == nullptr || known->entry.subscription.identity != entry.subscription.identity;
  const StoredSubscription& stored = store(std::move(entry), known);
  auto anew = review(stored.identity, is_new_identity);
  if (number_before != stored.identity) {
    const auto further = review(number_before, false);
    anew.insert(anew.end(), further.begin(), further.end());
  }
  std::erase(anew, &stored);
  if (telling == Telling::providers) untold_ = &stored;
  judge_all(stored);
  settle(stored);
  untold_ = nullptr;
  replaced_subscription_ = {};
  judge_anew(anew);
  relieve();
}

void Matcher::State::remove(const std::vector<const StoredPublication*>& publications,
                            const std::vector<const StoredSubscription*>& subscriptions, Reason reason) {
  begin_cause();
  for (const auto* publication : publications) retire(*publication, reason);
  for (const auto* subscription : subscriptions) of(*subscription).is_leaving = true;
  for (const auto* subscription : subscriptions) forget(*subscription, reason);
  std::vector<const StoredSubscription*> concerned;
  for (const auto* publication : publications) {
    for (const auto& [slot, rank] : of(*publication).considered_by) {
      of_subscription_[slot].choice.withdraw(rank, reason);
      concerned.push_back(of_subscription_[slot].stored);
    }
    of(*publication).considered_by.clear();
  }
  filed_ += concerned.size();
  order_by_key(concerned);
  for (const auto* subscription : concerned) settle(*subscription);
  std::set<Id32> numbers;
  for (const auto* publication : publications) erase(*publication, numbers);
  for (const auto* subscription : subscriptions) erase(*subscription, numbers);
  begin_cause();
  for (const Id32 number : numbers) judge_anew(review(number, false));
  relieve();
  if (has_stale()) rejudge_some();
}

void Matcher::State::erase(const StoredPublication& publication, std::set<Id32>& numbers) {
  if (clashing_.contains(publication.identity)) numbers.insert(publication.identity);
  filed_ += 1 + publication.classes[std::to_underlying(in_force_.generation)].size();
  publications_.erase(publication);
}

void Matcher::State::erase(const StoredSubscription& subscription, std::set<Id32>& numbers) {
  if (clashing_.contains(subscription.identity)) numbers.insert(subscription.identity);
  unwatch(subscription);
  of(subscription) = {};
  subscriptions_.erase(subscription);
}

void Matcher::State::forget(const StoredSubscription& subscription, Reason reason) {
  for (const auto& chosen : of(subscription).choice.chosen()) {
    tell_provider(Change::del, subscription, *chosen.publication, chosen.match, reason);
  }
  for (const auto& [rank, publication] : of(subscription).choice.candidates()) {
    of(*publication).considered_by.erase(subscription.slot);
    ++filed_;
  }
}

std::uint32_t Matcher::State::limit_of(const SubscriptionEntry& subscription) {
  const std::uint32_t limit = subscription.subscription.limit;
  if (subscription.is_local) return limit == 0 ? max_given : std::min(limit, max_given);
  if (!subscription.subscription.chosen.empty()) return 0;  // nothing is left to choose
  return limit <= max_counted_providers ? limit : 0;
}

bool Matcher::State::is_of_interest(const SubscriptionEntry& subscription, const PublicationEntry& publication) {
  if (subscription.is_local) return true;
  if (subscription.subscription.mode == ChannelMode::one_to_many_stream) return false;  // its provider is not told
  if (!subscription.subscription.chosen.empty()) {
    return publication.is_local && is_announced_choice(subscription, publication);
  }
  return publication.is_local || limit_of(subscription) != 0;  // without a limit nobody stands in another's way
}

bool Matcher::State::is_announced_choice(const SubscriptionEntry& subscription, const PublicationEntry& publication) {
  return std::ranges::binary_search(subscription.subscription.chosen, publication.key);
}

bool Matcher::State::was_chosen_unseen(const StoredPublication& publication) const {
  if (replaced_subscription_.stored == nullptr) return false;
  const SubscriptionEntry& before = replaced_subscription_.before;
  const Edition& edition = edition_of(replaced_generation_);
  const bool was_kept_apart =
      replaced_was_clashing_ && before.subscription.identity.index() != publication.entry.publication.identity.index();
  const bool was_announced = before.subscription.chosen.empty() || is_announced_choice(before, publication.entry);
  return was_announced && !is_of_interest(before, publication.entry) &&
         before.subscription.mode != ChannelMode::one_to_many_stream && !was_kept_apart &&
         matching::meets(before, replaced_request_, offer(publication, edition), edition.vocabulary);
}

bool Matcher::State::is_hopeless(const StoredSubscription& subscription, const StoredPublication& publication) {
  // What somebody is given who had no limit before is known only when the pair is judged.
  if (replaced_subscription_.stored != nullptr) return false;
  constexpr Match best_possible;
  auto& known = of(subscription);
  return known.choice.has_passed_over() &&
         known.choice.passes_over(known.request.rank(publication.entry, best_possible));
}

void Matcher::State::judge(const StoredSubscription& subscription, const StoredPublication& publication) {
  auto& considered_by = of(publication).considered_by;
  auto& choice = of(subscription).choice;
  const bool is_interesting = is_of_interest(subscription.entry, publication.entry);
  const auto known = considered_by.find(subscription.slot);
  if (!is_interesting && known == considered_by.end()) return;
  if (known == considered_by.end() && is_hopeless(subscription, publication)) return;
  has_waited_ = false;
  const auto match = meets(subscription, publication);
  if (has_waited_) of(subscription).is_waiting = true;
  if (!match || !is_interesting) {
    if (known == considered_by.end()) return;
    const Reason reason = match ? Reason::outranked : Reason::changed;  // its consumer has chosen others
    choice.withdraw(known->second, of(publication).leaves.value_or(reason));
    considered_by.erase(known);
    return;
  }
  const Rank rank = of(subscription).request.rank(publication.entry, *match);
  if (known != considered_by.end()) {
    choice.change(std::exchange(known->second, rank), rank);
  } else {
    const bool is_incumbent = was_chosen_unseen(publication);
    if (!is_incumbent && choice.passes_over(rank)) return;
    if (is_turned_away(subscription, publication)) return;
    considered_by.emplace(subscription.slot, rank);
    choice.offer(rank, publication, is_incumbent);
  }
  forget_dropped(subscription);
}

void Matcher::State::judge_all(const StoredSubscription& subscription) {
  for (const auto& [rank, publication] : of(subscription).choice.candidates()) judge(subscription, *publication);
  const Subscription& asked = subscription.entry.subscription;
  visit_publications(publications_, asked.identity, of(subscription).request.classes, asked.weakest,
                     edition_of(subscription), [&](const StoredPublication& publication) {
                       if (!of(publication).considered_by.contains(subscription.slot)) judge(subscription, publication);
                       return false;
                     });
}

void Matcher::State::refill(const StoredSubscription& subscription) {
  forget_dropped(subscription);
  const Subscription& asked = subscription.entry.subscription;
  visit_publications(publications_, asked.identity, of(subscription).request.classes, asked.weakest,
                     edition_of(subscription), [&](const StoredPublication& publication) {
                       auto& known = of(publication);
                       if (known.leaves || known.considered_by.contains(subscription.slot)) return false;
                       judge(subscription, publication);
                       return false;
                     });
}

void Matcher::State::forget_dropped(const StoredSubscription& subscription) {
  for (const auto* dropped : of(subscription).choice.take_dropped()) {
    of(*dropped).considered_by.erase(subscription.slot);
  }
}

std::vector<Ranked> Matcher::State::match(const SubscriptionEntry& entry, const Request& request) const {
  const Subscription& asked = entry.subscription;
  std::vector<Ranked> ranked;
  visit_publications(publications_, asked.identity, request.classes, asked.weakest, in_force_,
                     [&](const StoredPublication& publication) {
                       if (of_publication_[publication.slot].leaves) return false;
                       const auto match = meet(entry, request, publication, in_force_);
                       if (match) ranked.push_back({&publication.entry, request.rank(publication.entry, *match)});
                       return false;
                     });
  std::ranges::sort(ranked, BestFirst{}, &Ranked::rank);
  return ranked;
}

bool Matcher::State::is_served(const SubscriptionEntry& subscription) const {
  const Subscription& asked = subscription.subscription;
  const Request request = prepare(subscription, false);
  bool served = false;
  visit_publications(publications_, asked.identity, request.classes, asked.weakest, in_force_,
                     [&](const StoredPublication& publication) {
                       served = !of_publication_[publication.slot].leaves &&
                                meet(subscription, request, publication, in_force_).has_value();
                       return served;
                     });
  return served;
}

bool Matcher::State::is_used(const PublicationEntry& publication) const {
  const StoredPublication* stored = publications_.find(publication.key);
  return stored != nullptr &&
         std::ranges::any_of(subscriptions_for(*stored), [&](const StoredSubscription* subscription) {
           return meets(*subscription, *stored).has_value();
         });
}

}  // namespace geminga::matching
