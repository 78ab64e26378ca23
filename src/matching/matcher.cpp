// The matcher's face: it translates keys to entries and leaves the rest to its state.
#include "matching/matcher.hpp"

#include <algorithm>
#include <utility>

#include "matching/state.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

Matcher::Matcher(const el::Ontology* ontology, Placing placing)
    : state_(std::make_unique<State>(ontology, std::move(placing))) {}

Matcher::~Matcher() = default;

void Matcher::put(registry::PublicationEntry entry) { state_->put(std::move(entry)); }

void Matcher::put(registry::SubscriptionEntry entry) { state_->put(std::move(entry)); }

bool Matcher::remove_publication(const ServiceKey& key, Reason reason) {
  const StoredPublication* stored = state_->publications_.find(key);
  if (stored == nullptr) return false;
  state_->remove({stored}, {}, reason);
  return true;
}

bool Matcher::remove_subscription(const ServiceKey& key, Reason reason) {
  const StoredSubscription* stored = state_->subscriptions_.find(key);
  if (stored == nullptr) return false;
  state_->remove({}, {stored}, reason);
  return true;
}

void Matcher::remove_peer(ParticipantId participant, PeerId peer, Reason reason) {
  state_->remove(state_->publications_.of_peer(participant, peer), state_->subscriptions_.of_peer(participant, peer),
                 reason);
}

void Matcher::remove_participant(ParticipantId participant, Reason reason) {
  state_->remove(state_->publications_.of_participant(participant), state_->subscriptions_.of_participant(participant),
                 reason);
}

void Matcher::set_ontology(const el::Ontology* ontology) { state_->set_ontology(ontology); }

void Matcher::place_again() { state_->place_again(); }

std::vector<Event> Matcher::take_events() { return std::exchange(state_->events_, {}); }

std::vector<Ranked> Matcher::match(const Subscription& request) const {
  return state_->match(request, prepared(request, state_->ontology_, state_->placing_));
}

std::optional<Standing> Matcher::standing(const ServiceKey& subscription, const ServiceKey& publication) const {
  const StoredSubscription* asked = state_->subscriptions_.find(subscription);
  const StoredPublication* offered = state_->publications_.find(publication);
  if (asked == nullptr || offered == nullptr) return std::nullopt;
  return state_->standing(*asked, *offered);
}

std::expected<Match, std::string> Matcher::why(const registry::SubscriptionEntry& request,
                                               const registry::PublicationEntry& offer) const {
  const el::Ontology* ontology = state_->ontology_;
  return explained(request.subscription, state_->prepare(request), offer,
                   classes_of(offer.publication.identity, ontology), ontology);
}

void Matcher::for_each_publication(const std::function<void(const registry::PublicationEntry&)>& visit) const {
  state_->publications_.for_each([&visit](const StoredPublication& stored) { visit(stored.entry); });
}

void Matcher::for_each_subscription(const std::function<void(const registry::SubscriptionEntry&)>& visit) const {
  state_->subscriptions_.for_each([&visit](const StoredSubscription& stored) { visit(stored.entry); });
}

const registry::PublicationEntry* Matcher::find_publication(const ServiceKey& key) const {
  const StoredPublication* stored = state_->publications_.find(key);
  return stored == nullptr ? nullptr : &stored->entry;
}

const registry::SubscriptionEntry* Matcher::find_subscription(const ServiceKey& key) const {
  const StoredSubscription* stored = state_->subscriptions_.find(key);
  return stored == nullptr ? nullptr : &stored->entry;
}

bool Matcher::is_served(const registry::SubscriptionEntry& subscription) const {
  return state_->is_served(subscription);
}

bool Matcher::is_used(const registry::PublicationEntry& publication) const { return state_->is_used(publication); }

}  // namespace geminga::matching
