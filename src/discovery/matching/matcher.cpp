// The matcher's face: it translates keys to entries and leaves the rest to its state.
#include "discovery/matching/matcher.hpp"

#include <algorithm>
#include <utility>

#include "discovery/matching/obstacle.hpp"
#include "discovery/matching/representation.hpp"
#include "discovery/matching/state.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

Matcher::Matcher(vocabulary::Vocabulary vocabulary, Placing placing, Overlapping overlapping)
    : state_(std::make_unique<State>(std::move(vocabulary), std::move(placing), std::move(overlapping))) {}

Matcher::~Matcher() = default;

void Matcher::put(registry::PublicationEntry entry) { state_->put(std::move(entry)); }

void Matcher::put(registry::SubscriptionEntry entry, Telling telling) { state_->put(std::move(entry), telling); }

bool Matcher::remove_publication(const ServiceKey& key, Reason reason) {
  const StoredPublication* stored = state_->publications_.find(key);
  if (stored == nullptr || state_->is_going(*stored)) return false;
  state_->remove({stored}, {}, reason);
  return true;
}

bool Matcher::remove_subscription(const ServiceKey& key, Reason reason) {
  const StoredSubscription* stored = state_->subscriptions_.find(key);
  if (stored == nullptr || state_->is_going(*stored)) return false;
  state_->remove({}, {stored}, reason);
  return true;
}

void Matcher::remove_peer(ParticipantId participant, PeerId peer, Reason reason) {
  auto publications = state_->publications_.of_peer(participant, peer);
  auto subscriptions = state_->subscriptions_.of_peer(participant, peer);
  std::erase_if(publications, [&](const StoredPublication* one) { return state_->is_going(*one); });
  std::erase_if(subscriptions, [&](const StoredSubscription* one) { return state_->is_going(*one); });
  state_->remove(publications, subscriptions, reason);
}

void Matcher::begin_departure(ParticipantId participant, Reason reason) {
  state_->begin_departure(participant, reason);
}

bool Matcher::depart_next() { return state_->depart_next(); }

bool Matcher::is_departing() const { return !state_->departures_.empty(); }

const vocabulary::Vocabulary& Matcher::vocabulary() const { return state_->in_force_.vocabulary; }

std::string Matcher::chain_words(const ServiceKey& subscription, const vocabulary::Chain& chain) const {
  const StoredSubscription* asked = state_->subscriptions_.find(subscription);
  return asked == nullptr ? "" : matching::chain_words(&chain, state_->edition_of(*asked).vocabulary);
}

std::shared_ptr<const vocabulary::Chain> Matcher::chain(const ServiceKey& subscription,
                                                        const ServiceKey& publication) const {
  const StoredSubscription* asked = state_->subscriptions_.find(subscription);
  const StoredPublication* offered = state_->publications_.find(publication);
  return asked == nullptr || offered == nullptr ? nullptr : state_->chain_of(*asked, *offered);
}

bool Matcher::rejudge_next() { return state_->rejudge_next(); }

bool Matcher::has_stale() const { return state_->has_stale(); }

void Matcher::catch_up(const ServiceKey& subscription) {
  if (const StoredSubscription* stored = state_->subscriptions_.find(subscription)) state_->catch_up(*stored);
}

void Matcher::begin_vocabulary(vocabulary::Vocabulary next) { state_->begin_vocabulary(std::move(next)); }

bool Matcher::file_next() { return state_->file_next(); }

void Matcher::put_in_force() { state_->put_in_force(); }

bool Matcher::rematch_next() { return state_->rematch_next(); }

bool Matcher::take_prepared(vocabulary::Vocabulary prepared) { return state_->take_prepared(std::move(prepared)); }

void Matcher::place_again() { state_->place_again(); }

std::vector<Event> Matcher::take_events() { return std::exchange(state_->events_, {}); }

std::vector<Clash> Matcher::take_clashes() { return std::exchange(state_->clashes_, {}); }

std::optional<Standing> Matcher::standing(const ServiceKey& subscription, const ServiceKey& publication) {
  const StoredSubscription* asked = state_->subscriptions_.find(subscription);
  const StoredPublication* offered = state_->publications_.find(publication);
  if (asked == nullptr || offered == nullptr) return std::nullopt;
  return state_->standing(*asked, *offered);
}

std::optional<Standing> Matcher::standing(const ServiceKey& subscription, const ServiceKey& publication,
                                          const Place& place) {
  const StoredSubscription* asked = state_->subscriptions_.find(subscription);
  const StoredPublication* offered = state_->publications_.find(publication);
  if (asked == nullptr || offered == nullptr) return std::nullopt;
  return state_->standing(*asked, *offered, place);
}

std::size_t Matcher::counted_limit(const registry::SubscriptionEntry& subscription) {
  return State::counted_limit(subscription);
}

std::shared_ptr<const Request> Matcher::prepare(const registry::SubscriptionEntry& asked) const {
  return std::make_shared<const Request>(state_->prepare(asked));
}

std::shared_ptr<const Request> Matcher::prepare(const Subscription& asked) const {
  return std::make_shared<const Request>(prepared(asked, vocabulary(), state_->placing_, {}, state_->overlapping_));
}

OverlapAnswer Matcher::overlap(vocabulary::ClassNumber offered, const SemanticIdentity& requested,
                               const Classes& requested_classes) const {
  return state_->overlapping_ ? state_->overlapping_(vocabulary(), offered, requested, requested_classes, {})
                              : decided_at_once(vocabulary(), offered, requested, requested_classes);
}

std::optional<Match> Matcher::meets(const registry::SubscriptionEntry& asked, const Request& request,
                                    const registry::PublicationEntry& publication) const {
  return state_->meets(asked, request, publication);
}

std::optional<std::vector<ServiceKey>> Matcher::candidates(const Subscription& asked, const Request& request,
                                                           std::size_t most) const {
  std::vector<ServiceKey> keys;
  visit_publications(state_->publications_, asked.identity, request.classes, asked.weakest, state_->in_force_,
                     [&](const StoredPublication& publication) {
                       keys.push_back(publication.entry.key);
                       return keys.size() > most;
                     });
  if (keys.size() > most) return std::nullopt;
  return keys;
}

std::vector<ServiceKey> Matcher::some_candidates(const Subscription& asked, const Request& request,
                                                 std::size_t most) const {
  std::vector<ServiceKey> keys;
  visit_publications(state_->publications_, asked.identity, request.classes, asked.weakest, state_->in_force_,
                     [&](const StoredPublication& publication) {
                       if (keys.size() < most) keys.push_back(publication.entry.key);
                       return keys.size() >= most;
                     });
  return keys;
}

Finding Matcher::examine(const registry::SubscriptionEntry& asked, const Request& request,
                         const registry::PublicationEntry& offer) const {
  return state_->examine(asked, request, offer);
}

bool Matcher::examine_requests(const std::optional<ServiceKey>& after, const registry::PublicationEntry& offer,
                               const VisitFinding& visit) const {
  return state_->examine_requests(after, offer, visit);
}

std::size_t Matcher::examine_near(const registry::PublicationEntry& offer, std::size_t most,
                                  const VisitFinding& visit) const {
  return state_->examine_near(offer, most, visit);
}

std::size_t Matcher::waiting_converters() const { return state_->waiting_converters(); }

std::optional<std::vector<ServiceKey>> Matcher::known_choice(const registry::SubscriptionEntry& subscription) const {
  return state_->known_choice(subscription);
}

std::expected<Match, std::string> Matcher::why(const registry::SubscriptionEntry& request,
                                               const registry::PublicationEntry& offer, const AskChain& chains) const {
  ++state_->judged_;
  if (state_->is_kept_apart(offer.publication.identity, request.subscription.identity)) {
    return std::unexpected(
        "identity: the number is that of two different services, and connects neither with whoever states the number");
  }
  const Imagined imagined(offer, vocabulary());
  Request prepared = state_->prepare(request);
  if (chains) prepared.chains = chains;
  return explained(request, prepared, imagined.offer, vocabulary());
}

bool Matcher::walk_publications(const std::optional<ServiceKey>& after, const VisitPublication& visit) const {
  return state_->publications_.visit_after(after,
                                           [&visit](const StoredPublication& stored) { return visit(stored.entry); });
}

bool Matcher::walk_subscriptions(const std::optional<ServiceKey>& after, const VisitSubscription& visit) const {
  return state_->subscriptions_.visit_after(after,
                                            [&visit](const StoredSubscription& stored) { return visit(stored.entry); });
}

std::size_t Matcher::publication_count() const { return state_->publications_.size(); }
std::size_t Matcher::subscription_count() const { return state_->subscriptions_.size(); }
std::vector<ServiceKey> Matcher::chosen(const ServiceKey& subscription) const { return state_->chosen(subscription); }
std::vector<ServiceKey> Matcher::announced_choice(const ServiceKey& subscription) const {
  return state_->announced_choice(subscription);
}
bool Matcher::take_choice_change() { return std::exchange(state_->has_choice_changed_, false); }
std::vector<ServiceKey> Matcher::consumers(const ServiceKey& publication) const {
  return state_->consumers(publication);
}
std::optional<Match> Matcher::given(const ServiceKey& subscription, const ServiceKey& publication) const {
  return state_->given(subscription, publication);
}
std::uint64_t Matcher::judged() const { return state_->judged_; }
std::uint64_t Matcher::filed() const { return state_->filed_; }

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
std::set<std::string> Matcher::converters_in_use() const { return state_->converters_in_use(); }

}  // namespace geminga::matching
