// What follows where a converter comes, goes or changes: which subscriptions are stale, and how they are judged anew.
#include <memory>
#include <ranges>
#include <string_view>
#include <utility>

#include "discovery/matching/representation.hpp"
#include "discovery/matching/state.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

Request Matcher::State::prepare(const SubscriptionEntry& entry, bool must_convert) const {
  Request request = prepared(entry.subscription, in_force_.vocabulary, placing_, entry.key.participant, overlapping_);
  if (!request.classes.representation_class || (!must_convert && entry.subscription.convert == 0)) return request;
  const auto asking = [&](std::shared_ptr<const Consumer> consumer) -> AskChain {
    return [converters = in_force_.converters, consumer = std::move(consumer)](vocabulary::ClassNumber offered,
                                                                               vocabulary::ClassNumber requested) {
      return converters->chain(*consumer, offered, requested);
    };
  };
  const vocabulary::Units& declared = in_force_.vocabulary.units();
  request.consumer =
      std::make_shared<const Consumer>(Consumer{.entry = entry, .scope = request.scope, .declared = declared});
  request.chains = asking(request.consumer);
  if (!must_convert) return request;
  SubscriptionEntry of_all = entry;
  of_all.subscription.providers.clear();
  of_all.subscription.protocols.clear();
  request.chains_of_all =
      asking(std::make_shared<const Consumer>(Consumer{.entry = of_all, .scope = Scope(), .declared = declared}));
  return request;
}

void Matcher::State::retire(const StoredPublication& stored, Reason reason) {
  of(stored).leaves = reason;
  for (const Edition* edition : {&in_force_, &other_}) {
    if (edition->converters == nullptr || edition->converters->is_empty()) continue;
    edition->converters->erase(stored.entry.key);
    filed_ += edition->converters->take_work();
  }
}

void Matcher::State::watch(const StoredSubscription& stored) {
  const Request& request = of(stored).request;
  if (request.consumer == nullptr) return;
  edition_of(stored).converters->watch(request.consumer, *request.classes.representation_class);
}

void Matcher::State::unwatch(const StoredSubscription& stored) {
  edition_of(stored).converters->unwatch(stored.entry.key);
}

std::shared_ptr<const vocabulary::Chain> Matcher::State::chain_of(const StoredSubscription& subscription,
                                                                  const StoredPublication& publication) const {
  const Edition& edition = edition_of(subscription);
  const Request& request = of_subscription_[subscription.slot].request;
  return chain_between(classes(publication, edition).representation_class, request.classes.representation_class,
                       edition.vocabulary, request.chains);
}

std::set<std::string> Matcher::State::converters_in_use() const {
  std::set<std::string> places;
  if (in_force_.converters->is_empty()) return places;
  subscriptions_.visit_after(std::nullopt, [&](const StoredSubscription& stored) {
    const Subscription& asked = stored.entry.subscription;
    if (asked.convert == 0) return true;
    const auto add = [&](const StoredPublication& publication) {
      const auto match = meets(stored, publication);
      const auto chain = match && match->cost != 0 ? chain_of(stored, publication) : nullptr;
      if (chain == nullptr || chain->via.empty()) return false;
      for (const auto step : std::views::split(chain->via, ',')) places.emplace(std::string_view(step));
      return false;
    };
    visit_publications(publications_, asked.identity, of_subscription_[stored.slot].request.classes, asked.weakest,
                       edition_of(stored), add);
    return true;
  });
  return places;
}

void Matcher::State::rejudge(const StoredSubscription& subscription) {
  const Edition& edition = edition_of(subscription);
  const ServiceKey& key = subscription.entry.key;
  if (!edition.converters->stale().contains(key)) return;
  edition.converters->refresh(key);
  if (of(subscription).is_leaving) return;
  const Subscription& asked = subscription.entry.subscription;
  visit_publications(publications_, asked.identity, of(subscription).request.classes, asked.weakest, edition,
                     [&](const StoredPublication& publication) {
                       ++filed_;
                       if (of(publication).leaves) return false;
                       const auto& considered_by = of(publication).considered_by;
                       const auto known = considered_by.find(subscription.slot);
                       const auto chain = chain_of(subscription, publication);
                       const bool is_converted = chain != nullptr && chain->cost <= asked.convert;
                       const std::uint32_t mark = is_converted ? chain->mark : 0;
                       // What is met without a conversion keeps that, or was not looked at because of its chain.
                       const std::uint32_t was = known == considered_by.end() ? 0 : known->second.match.chain;
                       if (mark != was) judge(subscription, publication);
                       return false;
                     });
}

void Matcher::State::catch_up(const StoredSubscription& subscription) {
  if (!edition_of(subscription).converters->stale().contains(subscription.entry.key)) return;
  begin_cause();
  settle(subscription);
}

bool Matcher::State::rejudge_next() {
  if (!has_stale()) return false;
  const Edition& edition = in_force_.converters->stale().empty() ? other_ : in_force_;
  const ServiceKey key = *edition.converters->stale().begin();
  const StoredSubscription* stored = subscriptions_.find(key);
  if (stored == nullptr) {
    edition.converters->refresh(key);
  } else {
    catch_up(*stored);
  }
  return true;
}

void Matcher::State::rejudge_some() {
  for (std::size_t count = 0; count < max_rejudged_at_once && rejudge_next(); ++count) {
  }
}

}  // namespace geminga::matching
