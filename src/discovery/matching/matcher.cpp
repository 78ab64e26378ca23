#include "discovery/matching/matcher.hpp"

#include <algorithm>
#include <ranges>
#include <string_view>

#include "discovery/matching/degrees/representation.hpp"
#include "discovery/matching/interest.hpp"

namespace geminga::matching {

using registry::PublicationEntry;
using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

Matcher::Matcher(const vocabulary::Vocabulary& vocabulary, Placing placing, Overlapping overlapping,
                 Comparing comparing)
    : editions_(vocabulary),
      preparation_(editions_, std::move(placing), std::move(overlapping), std::move(comparing)),
      directory_(editions_, preparation_),
      clashes_(directory_.publications(), directory_.subscriptions()),
      judge_(directory_, clashes_),
      events_(directory_),
      pairs_(directory_, judge_, events_),
      agenda_(editions_, directory_, judge_, pairs_),
      departures_(directory_, clashes_, pairs_, agenda_),
      change_(editions_, preparation_, directory_, judge_, pairs_, agenda_),
      examination_(editions_, preparation_, directory_, judge_) {}

template <typename Entry>
const registry::Stored<Entry>* Matcher::known_before(const registry::Table<Entry>& table, const Entry& entry) {
  const registry::Stored<Entry>* known = table.find(entry.key);
  if (known == nullptr) return nullptr;
  if (directory_.is_going(*known)) {
    departures_.finish();
    return nullptr;
  }
  if (known->entry.is_local == entry.is_local) return known;
  departures_.remove(*known, Reason::changed);
  return nullptr;
}

void Matcher::put(PublicationEntry entry) {
  const bool is_local = entry.is_local;
  settle_air(is_local);
  const bool was_idle = agenda_.is_empty();
  const StoredPublication* known = known_before(directory_.publications(), entry);
  if (known != nullptr && known->entry.same_as(entry)) {
    directory_.refresh(*known, entry.updated);
    return;
  }
  const Id32 number_before = known == nullptr ? id32(entry.publication.identity) : known->identity;
  const bool is_new_identity = known == nullptr || known->entry.publication.identity != entry.publication.identity;
  Cause cause;
  if (known == nullptr) {
    known = &directory_.add(std::move(entry));
    pairs_.add(*known);
  } else {
    agenda_.supersede(*known);
    cause.replace(*known, directory_.replace(*known, std::move(entry)));
  }
  const auto anew = clashes_.review_change(number_before, known->identity, is_new_identity);
  auto concerned = directory_.subscriptions_found_for(*known);
  const ConsideredBy& considered_by = pairs_.considered_by(*known);
  const bool is_much = concerned.size() > max_judged_in_step || considered_by.size() > max_judged_in_step;
  if (!is_local && (is_much || !anew.empty())) {
    const bool must_look_back = is_new_identity || editions_.stage() != ChangeStage::none;
    agenda_.judge(*known, std::make_unique<Cause>(std::move(cause)), std::move(concerned), must_look_back);
    agenda_.judge_anew(anew);
  } else {
    for (const auto& [slot, rank] : considered_by) concerned.push_back(&directory_.subscription_at(slot));
    order_by_key(concerned);
    for (const auto* subscription : concerned) {
      if (std::ranges::find(anew, subscription) != anew.end()) continue;
      pairs_.judge(*subscription, *known, cause);
      pairs_.settle(*subscription, cause);
    }
    pairs_.judge_anew(anew, cause);
  }
  if (known->entry.publication.mode == ChannelMode::participant)
    agenda_.judge_services_of(known->entry.key.participant);
  agenda_.relieve();
  if (was_idle) agenda_.take_some();
}

void Matcher::put(SubscriptionEntry entry, Telling telling) {
  const bool is_local = entry.is_local;
  settle_air(is_local);
  const bool was_idle = agenda_.is_empty();
  const StoredSubscription* known = known_before(directory_.subscriptions(), entry);
  if (known != nullptr && known->entry.same_as(entry)) {
    directory_.refresh(*known, entry.updated);
    return;
  }
  const Id32 number_before = known == nullptr ? id32(entry.subscription.identity) : known->identity;
  const bool is_new_identity = known == nullptr || known->entry.subscription.identity != entry.subscription.identity;
  Request request = preparation_.prepare(entry, false);
  Cause cause;
  if (known == nullptr) {
    known = &directory_.add(std::move(entry), std::move(request));
    pairs_.prepare(*known, nullptr);
  } else {
    agenda_.supersede(*known);
    const bool was_clashing = clashes_.contains(known->identity);
    cause.replace(*known, directory_.replace(*known, std::move(entry), std::move(request)), was_clashing);
    pairs_.prepare(*known, &cause.replaced_subscription()->before.request);
  }
  auto anew = clashes_.review_change(number_before, known->identity, is_new_identity);
  std::erase(anew, known);
  // While the vocabulary changes, the request that was replaced may be one of an edition that goes before the last
  // step.
  if (is_local || editions_.stage() != ChangeStage::none) {
    if (telling == Telling::providers) cause.untold = known;
    pairs_.judge_all(*known, cause);
    pairs_.settle(*known, cause);
  } else {
    agenda_.judge(*known, std::make_unique<Cause>(std::move(cause)));
  }
  if (is_local) {
    Cause further;
    pairs_.judge_anew(anew, further);
  } else {
    agenda_.judge_anew(anew);
  }
  agenda_.relieve();
  if (was_idle) agenda_.take_some();
}

bool Matcher::remove_publication(const ServiceKey& key, Reason reason) {
  const StoredPublication* stored = directory_.publications().find(key);
  if (stored == nullptr || directory_.is_going(*stored)) return false;
  settle_air(stored->entry.is_local);
  departures_.remove(*stored, reason);
  return true;
}

bool Matcher::remove_subscription(const ServiceKey& key, Reason reason) {
  const StoredSubscription* stored = directory_.subscriptions().find(key);
  if (stored == nullptr || directory_.is_going(*stored)) return false;
  settle_air(stored->entry.is_local);
  departures_.remove(*stored, reason);
  return true;
}

bool Matcher::begin_removal_of_publication(const ServiceKey& key, Reason reason) {
  const StoredPublication* stored = directory_.publications().find(key);
  if (stored == nullptr || directory_.is_going(*stored)) return false;
  departures_.begin(*stored, reason);
  return true;
}

bool Matcher::begin_removal_of_subscription(const ServiceKey& key, Reason reason) {
  const StoredSubscription* stored = directory_.subscriptions().find(key);
  if (stored == nullptr || directory_.is_going(*stored)) return false;
  departures_.begin(*stored, reason);
  return true;
}

void Matcher::remove_peer(ParticipantId participant, PeerId peer, Reason reason) {
  auto publications = directory_.publications().of_peer(participant, peer);
  auto subscriptions = directory_.subscriptions().of_peer(participant, peer);
  std::erase_if(publications, [&](const StoredPublication* one) { return directory_.is_going(*one); });
  std::erase_if(subscriptions, [&](const StoredSubscription* one) { return directory_.is_going(*one); });
  departures_.remove(publications, subscriptions, reason);
}

void Matcher::catch_up(const ServiceKey& subscription) {
  if (const StoredSubscription* stored = directory_.subscriptions().find(subscription)) agenda_.catch_up(*stored);
}

std::vector<ServiceKey> Matcher::chosen(const ServiceKey& subscription) const {
  std::vector<ServiceKey> keys;
  const StoredSubscription* stored = directory_.subscriptions().find(subscription);
  if (stored == nullptr) return keys;
  for (const auto& one : pairs_.choice(*stored).chosen()) keys.push_back(one.publication->entry.key);
  return keys;
}

std::vector<ServiceKey> Matcher::consumers(const ServiceKey& publication) const {
  std::vector<ServiceKey> keys;
  const StoredPublication* stored = directory_.publications().find(publication);
  if (stored == nullptr || !is_provider_told(stored->entry.publication.mode)) return keys;
  for (const auto& [slot, rank] : pairs_.considered_by(*stored)) {
    const StoredSubscription& one = directory_.subscription_at(slot);
    if (pairs_.choice(one).is_chosen(rank)) keys.push_back(one.entry.key);
  }
  return keys;
}

std::optional<Match> Matcher::given(const ServiceKey& subscription, const ServiceKey& publication) const {
  const StoredSubscription* asks = directory_.subscriptions().find(subscription);
  const StoredPublication* offers = directory_.publications().find(publication);
  return asks == nullptr || offers == nullptr ? std::nullopt : pairs_.chosen_match(*asks, *offers);
}

std::vector<ServiceKey> Matcher::announced_choice(const ServiceKey& subscription) const {
  const StoredSubscription* stored = directory_.subscriptions().find(subscription);
  return stored == nullptr ? std::vector<ServiceKey>() : pairs_.announced().keys(*stored);
}

std::shared_ptr<const vocabulary::Chain> Matcher::chain(const ServiceKey& subscription,
                                                        const ServiceKey& publication) const {
  const StoredSubscription* asked = directory_.subscriptions().find(subscription);
  const StoredPublication* offered = directory_.publications().find(publication);
  return asked == nullptr || offered == nullptr ? nullptr : directory_.chain(*asked, *offered);
}

std::string Matcher::chain_words(const ServiceKey& subscription, const vocabulary::Chain& chain) const {
  const StoredSubscription* asked = directory_.subscriptions().find(subscription);
  return asked == nullptr ? "" : matching::chain_words(&chain, directory_.edition_of(*asked).vocabulary);
}

const PublicationEntry* Matcher::find_publication(const ServiceKey& key) const {
  const StoredPublication* stored = directory_.publications().find(key);
  return stored == nullptr ? nullptr : &stored->entry;
}

const SubscriptionEntry* Matcher::find_subscription(const ServiceKey& key) const {
  const StoredSubscription* stored = directory_.subscriptions().find(key);
  return stored == nullptr ? nullptr : &stored->entry;
}

base::Instant Matcher::updated(const PublicationEntry& entry) const {
  const StoredPublication* stored = directory_.publications().find(entry.key);
  return stored == nullptr ? base::Instant() : stored->updated;
}

base::Instant Matcher::updated(const SubscriptionEntry& entry) const {
  const StoredSubscription* stored = directory_.subscriptions().find(entry.key);
  return stored == nullptr ? base::Instant() : stored->updated;
}

bool Matcher::walk_publications(const std::optional<ServiceKey>& after,
                                const std::function<bool(const PublicationEntry&)>& visit) const {
  return directory_.publications().visit_after(after,
                                               [&visit](const StoredPublication& one) { return visit(one.entry); });
}

bool Matcher::walk_subscriptions(const std::optional<ServiceKey>& after,
                                 const std::function<bool(const SubscriptionEntry&)>& visit) const {
  return directory_.subscriptions().visit_after(after,
                                                [&visit](const StoredSubscription& one) { return visit(one.entry); });
}

bool Matcher::is_served(const SubscriptionEntry& subscription) const {
  const Request request = preparation_.prepare(subscription, false);
  bool is_served = false;
  directory_.visit_publications_for(subscription.subscription, request, [&](const StoredPublication& publication) {
    is_served = !directory_.is_going(publication) &&
                judge_.judge(subscription, request, publication, editions_.in_force()).match.has_value();
    return is_served;
  });
  return is_served;
}

bool Matcher::is_used(const PublicationEntry& publication) const {
  const StoredPublication* stored = directory_.publications().find(publication.key);
  return stored != nullptr &&
         std::ranges::any_of(directory_.subscriptions_for(*stored), [&](const StoredSubscription* subscription) {
           return judge_.judge(*subscription, *stored).match.has_value();
         });
}

std::set<std::string> Matcher::converters_in_use() const {
  std::set<std::string> places;
  if (editions_.in_force().converters->is_empty()) return places;
  directory_.subscriptions().visit_after(std::nullopt, [&](const StoredSubscription& subscription) {
    if (subscription.entry.subscription.convert == 0) return true;
    directory_.visit_publications_for(subscription, [&](const StoredPublication& publication) {
      const auto match = judge_.judge(subscription, publication).match;
      const auto chain = match && match->cost != 0 ? directory_.chain(subscription, publication) : nullptr;
      if (chain == nullptr || chain->via.empty()) return false;
      for (const auto step : std::views::split(chain->via, ',')) places.emplace(std::string_view(step));
      return false;
    });
    return true;
  });
  return places;
}

std::shared_ptr<const Request> Matcher::prepare(const SubscriptionEntry& asked) const {
  return std::make_shared<const Request>(preparation_.prepare(asked, true));
}

std::shared_ptr<const Request> Matcher::prepare(const Subscription& asked) const {
  return std::make_shared<const Request>(preparation_.prepare(asked));
}

std::optional<Match> Matcher::meets(const SubscriptionEntry& asked, const Request& request,
                                    const PublicationEntry& publication) const {
  const StoredPublication* stored = directory_.publications().find(publication.key);
  if (stored == nullptr || directory_.is_going(*stored)) return std::nullopt;
  return judge_.judge(asked, request, *stored, editions_.in_force()).match;
}

std::optional<std::vector<ServiceKey>> Matcher::candidates(const Subscription& asked, const Request& request,
                                                           std::size_t most) const {
  auto keys = some_candidates(asked, request, most + 1);
  return keys.size() > most ? std::nullopt : std::optional(std::move(keys));
}

std::vector<ServiceKey> Matcher::some_candidates(const Subscription& asked, const Request& request,
                                                 std::size_t most) const {
  std::vector<ServiceKey> keys;
  directory_.visit_publications_for(asked, request, [&](const StoredPublication& publication) {
    if (keys.size() < most) keys.push_back(publication.entry.key);
    return keys.size() >= most;
  });
  return keys;
}

std::optional<Standing> Matcher::standing(const ServiceKey& subscription, const ServiceKey& publication) {
  const StoredSubscription* asked = directory_.subscriptions().find(subscription);
  const StoredPublication* offered = directory_.publications().find(publication);
  if (asked == nullptr || offered == nullptr) return std::nullopt;
  change_.catch_up(*asked);
  const auto place = ranked_place(*asked, *offered, directory_, judge_, editions_.in_force());
  return place ? std::optional(standing_of(*asked, *offered, *place, directory_, pairs_)) : std::nullopt;
}

std::optional<Standing> Matcher::standing(const ServiceKey& subscription, const ServiceKey& publication,
                                          const Place& place) {
  const StoredSubscription* asked = directory_.subscriptions().find(subscription);
  const StoredPublication* offered = directory_.publications().find(publication);
  if (asked == nullptr || offered == nullptr) return std::nullopt;
  change_.catch_up(*asked);
  return standing_of(*asked, *offered, place, directory_, pairs_);
}

std::optional<std::vector<ServiceKey>> Matcher::known_choice(const SubscriptionEntry& subscription) const {
  const auto& announced = subscription.subscription.chosen;
  if (!subscription.is_local && !announced.empty()) return announced;
  return is_chosen_here(subscription) ? std::optional(chosen(subscription.key)) : std::nullopt;
}

}  // namespace geminga::matching
