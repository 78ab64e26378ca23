#include "discovery/matching/matcher.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace geminga::matching {

using registry::PublicationEntry;
using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

namespace {

/// The entry of offers or requests with this key; null where there is none or it is about to be erased.
template <typename Owner>
auto* staying(const Owner& owner, const ServiceKey& key) {
  const auto* stored = owner.table().find(key);
  return stored == nullptr || owner.is_going(*stored) ? nullptr : stored;
}

}  // namespace

Matcher::Matcher(const vocabulary::Vocabulary& vocabulary, Placing placing, Overlapping overlapping,
                 Comparing comparing)
    : editions_(vocabulary),
      preparation_(editions_, std::move(placing), std::move(overlapping), std::move(comparing)),
      directory_(editions_, preparation_),
      clashes_(directory_.offers().table(), directory_.requests().table()),
      judge_(directory_, clashes_),
      events_(directory_),
      pairs_(directory_, judge_, events_),
      agenda_(editions_, directory_, judge_, pairs_),
      departures_(directory_, clashes_, pairs_, agenda_),
      change_(editions_, preparation_, directory_, judge_, pairs_, agenda_),
      choices_(directory_, pairs_),
      examination_(editions_, preparation_, directory_, judge_),
      search_(editions_, preparation_, directory_, judge_, examination_) {}

template <typename Owner, typename Entry>
const registry::Stored<Entry>* Matcher::known_before(const Owner& owner, const Entry& entry) {
  const registry::Stored<Entry>* known = owner.table().find(entry.key);
  if (known == nullptr) return nullptr;
  if (owner.is_going(*known)) {
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
  const StoredPublication* known = known_before(directory_.offers(), entry);
  if (known != nullptr && known->entry.same_as(entry)) {
    directory_.offers().refresh(*known, entry.updated);
    return;
  }
  const Id32 number_before = known == nullptr ? id32(entry.publication.identity) : known->identity;
  const bool is_new_identity = known == nullptr || known->entry.publication.identity != entry.publication.identity;
  Cause cause;
  if (known == nullptr) {
    known = &directory_.offers().add(std::move(entry));
    pairs_.add(*known);
  } else {
    agenda_.supersede(*known);
    cause.replace(*known, directory_.offers().replace(*known, std::move(entry)));
  }
  const auto anew = clashes_.review_change(number_before, known->identity,
                                           is_new_identity ? Clashes::Change::came : Clashes::Change::stayed);
  auto concerned = directory_.subscriptions_found_for(*known);
  const ConsideredBy& considered_by = pairs_.considered_by(*known);
  const bool is_much = concerned.size() > max_judged_in_step || considered_by.size() > max_judged_in_step;
  if (!is_local && (is_much || !anew.empty())) {
    const bool must_look_back = is_new_identity || editions_.stage() != ChangeStage::none;
    agenda_.judge(*known, std::make_unique<Cause>(std::move(cause)), std::move(concerned),
                  must_look_back ? Agenda::LookBack::at_candidates : Agenda::LookBack::none);
    agenda_.judge_anew(anew);
  } else {
    for (const auto& [slot, rank] : considered_by) concerned.push_back(&directory_.requests().at(slot));
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
  const StoredSubscription* known = known_before(directory_.requests(), entry);
  if (known != nullptr && known->entry.same_as(entry)) {
    directory_.requests().refresh(*known, entry.updated);
    return;
  }
  const Id32 number_before = known == nullptr ? id32(entry.subscription.identity) : known->identity;
  const bool is_new_identity = known == nullptr || known->entry.subscription.identity != entry.subscription.identity;
  Request request = preparation_.prepare(entry);
  Cause cause;
  if (known == nullptr) {
    known = &directory_.requests().add(std::move(entry), std::move(request));
    pairs_.prepare(*known, nullptr);
  } else {
    agenda_.supersede(*known);
    const bool was_clashing = clashes_.contains(known->identity);
    cause.replace(*known, directory_.requests().replace(*known, std::move(entry), std::move(request)), was_clashing);
    pairs_.prepare(*known, &cause.replaced_subscription()->before.request);
  }
  auto anew = clashes_.review_change(number_before, known->identity,
                                     is_new_identity ? Clashes::Change::came : Clashes::Change::stayed);
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
  const auto* stored = staying(directory_.offers(), key);
  if (stored == nullptr) return false;
  settle_air(stored->entry.is_local);
  departures_.remove(*stored, reason);
  return true;
}

bool Matcher::remove_subscription(const ServiceKey& key, Reason reason) {
  const auto* stored = staying(directory_.requests(), key);
  if (stored == nullptr) return false;
  settle_air(stored->entry.is_local);
  departures_.remove(*stored, reason);
  return true;
}

bool Matcher::begin_removal_of_publication(const ServiceKey& key, Reason reason) {
  const auto* stored = staying(directory_.offers(), key);
  if (stored == nullptr) return false;
  departures_.begin(*stored, reason);
  return true;
}

bool Matcher::begin_removal_of_subscription(const ServiceKey& key, Reason reason) {
  const auto* stored = staying(directory_.requests(), key);
  if (stored == nullptr) return false;
  departures_.begin(*stored, reason);
  return true;
}

void Matcher::remove_peer(ParticipantId participant, PeerId peer, Reason reason) {
  auto publications = directory_.offers().table().of_peer(participant, peer);
  auto subscriptions = directory_.requests().table().of_peer(participant, peer);
  std::erase_if(publications, [&](const StoredPublication* one) { return directory_.offers().is_going(*one); });
  std::erase_if(subscriptions, [&](const StoredSubscription* one) { return directory_.requests().is_going(*one); });
  departures_.remove(publications, subscriptions, reason);
}

void Matcher::catch_up(const ServiceKey& subscription) {
  if (const StoredSubscription* stored = directory_.requests().table().find(subscription)) agenda_.catch_up(*stored);
}

}  // namespace geminga::matching
