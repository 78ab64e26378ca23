#include "discovery/participant/clients/own_services.hpp"

#include <algorithm>
#include <type_traits>

#include "discovery/announcement/announceable.hpp"

namespace geminga::participant {

ServiceKey OwnServices::key_of(const Session& session, std::uint32_t number) const {
  return ServiceKey{.participant = self_.id, .peer = session.peer(), .number = number};
}

void OwnServices::enter(const Session& session, std::uint32_t number, const StatedPublication& stated) {
  if (!stated.is_in_force) return;
  registry::PublicationEntry entry{.key = key_of(session, number),
                                   .publication = stated.service,
                                   .peer_name = session.name,
                                   .participant_name = self_.name(),
                                   .is_local = true,
                                   .updated = env_.now()};
  if (entry.publication.address.empty()) entry.publication.address = local_address;
  matcher_.put(std::move(entry));
  is_changed_ = true;
}

void OwnServices::enter(const Session& session, std::uint32_t number, const StatedSubscription& stated,
                        matching::Matcher::Telling telling) {
  if (!stated.is_in_force) return;
  registry::SubscriptionEntry entry{.key = key_of(session, number),
                                    .subscription = stated.service,
                                    .peer_name = session.name,
                                    .participant_name = self_.name(),
                                    .is_local = true,
                                    .updated = env_.now()};
  if (entry.subscription.address.empty()) entry.subscription.address = local_address;
  matcher_.put(std::move(entry), telling);
  is_changed_ |= !stated.is_quiet;
}

void OwnServices::withdraw_publication(const Session& session, std::uint32_t number, matching::Reason reason) {
  is_changed_ |= matcher_.remove_publication(key_of(session, number), reason);
}

void OwnServices::withdraw_subscription(const Session& session, std::uint32_t number, matching::Reason reason) {
  const auto stated = session.subscriptions.find(number);
  const bool is_quiet = stated != session.subscriptions.end() && stated->second.is_quiet;
  is_changed_ |= matcher_.remove_subscription(key_of(session, number), reason) && !is_quiet;
}

void OwnServices::forget_publication(Session& session, std::uint32_t number) {
  withdraw_publication(session, number, matching::Reason::withdrawn);
  session.publications.erase(number);
  session.forget(number);
}

void OwnServices::forget_subscription(Session& session, std::uint32_t number) {
  withdraw_subscription(session, number, matching::Reason::withdrawn);
  session.quiet -= session.subscriptions.at(number).is_quiet ? 1 : 0;
  session.subscriptions.erase(number);
  session.forget(number);
}

void OwnServices::suspend(Session& session, std::uint32_t number, const StatedPublication& stated) {
  if (!stated.is_in_force) return;
  telling_.tell_gone(session, number, matching::Reason::changed);
  withdraw_publication(session, number, matching::Reason::changed);
}

void OwnServices::suspend(Session& session, std::uint32_t number, const StatedSubscription& stated) {
  if (!stated.is_in_force) return;
  telling_.tell_gone(session, number, matching::Reason::changed);
  withdraw_subscription(session, number, matching::Reason::changed);
}

bool OwnServices::is_small(const Session& session) const {
  return session.service_count() * sessions_.service_count() <= max_pairs_at_once;
}

void OwnServices::withdraw_all(Session& session) {
  is_changed_ |= session.shared_count() > 0;
  matcher_.remove_peer(self_.id, session.peer(), matching::Reason::withdrawn);
  session.publications.clear();
  session.subscriptions.clear();
  session.quiet = 0;
  session.told.clear();
  session.resyncs.clear();
  session.to_rename.clear();
}

void OwnServices::withdraw_one(Session& session) {
  if (!session.subscriptions.empty()) {
    forget_subscription(session, session.subscriptions.rbegin()->first);
  } else if (!session.publications.empty()) {
    forget_publication(session, session.publications.rbegin()->first);
  }
}

void OwnServices::rename(Session& session) {
  for (const auto& [number, stated] : session.publications) session.to_rename.insert(number);
  for (const auto& [number, stated] : session.subscriptions) session.to_rename.insert(number);
  if (!is_small(session)) return;
  while (!session.to_rename.empty()) rename_one(session);
}

void OwnServices::rename_one(Session& session) {
  const std::uint32_t number = *session.to_rename.begin();
  session.to_rename.erase(session.to_rename.begin());
  if (const auto one = session.publications.find(number); one != session.publications.end()) {
    enter(session, number, one->second);
  }
  if (const auto one = session.subscriptions.find(number); one != session.subscriptions.end()) {
    enter(session, number, one->second);
  }
}

void OwnServices::list_returning() {
  returning_.clear();
  for (const auto& [stream, session] : sessions_.all) {
    for (const auto& [number, stated] : session->publications) returning_.push_back({stream, number});
    for (const auto& [number, stated] : session->subscriptions) returning_.push_back({stream, number});
  }
  std::ranges::reverse(returning_);
}

bool OwnServices::return_next() {
  if (returning_.empty()) return false;
  const auto [stream, number] = returning_.back();
  returning_.pop_back();
  Session* session = sessions_.find(stream);
  if (session == nullptr) return true;
  work_.add(cost_of_statement);
  telling_.tell_gone(*session, number, matching::Reason::renamed);
  if (const auto one = session->publications.find(number); one != session->publications.end()) {
    enter(*session, number, one->second);
    if (one->second.is_in_force) session->resyncs[number] = {};
  }
  if (const auto one = session->subscriptions.find(number); one != session->subscriptions.end()) {
    enter(*session, number, one->second, matching::Matcher::Telling::providers);
    if (one->second.is_in_force) session->resyncs[number] = {};
  }
  return true;
}

void OwnServices::list_for_restating(bool is_of_all) {
  restated_.clear();
  for (const auto& [stream, session] : sessions_.all) {
    for (const auto& [number, stated] : session->publications) {
      if (is_of_all || stated.is_awaited) restated_.push_back({stream, number});
    }
    for (const auto& [number, stated] : session->subscriptions) {
      if (is_of_all || stated.is_awaited) restated_.push_back({stream, number});
    }
  }
  std::ranges::reverse(restated_);
}

bool OwnServices::restate_next() {
  if (restated_.empty()) return false;
  const auto [stream, number] = restated_.back();
  restated_.pop_back();
  Session* session = sessions_.find(stream);
  if (session == nullptr) return true;
  work_.add(cost_of_statement);
  if (const auto one = session->publications.find(number); one != session->publications.end()) {
    StatedPublication& stated = one->second;
    const bool is_known = resolve_again(*session, number, stated, stated.service);
    if (self_.is_claimed() && is_known) enter(*session, number, stated);
    if (self_.is_claimed() && !is_known) withdraw_publication(*session, number, matching::Reason::changed);
  }
  if (const auto one = session->subscriptions.find(number); one != session->subscriptions.end()) {
    StatedSubscription& stated = one->second;
    const bool is_known = resolve_again(*session, number, stated, stated.service);
    if (self_.is_claimed() && is_known) enter(*session, number, stated);
    if (self_.is_claimed() && !is_known) withdraw_subscription(*session, number, matching::Reason::changed);
  }
  return true;
}

/// Sets the identity that the ontology gives to the names. False where it does not know them, or is not prepared for
/// them yet; then the peer was told.
template <typename Stated, typename Service>
bool OwnServices::resolve_again(Session& session, std::uint32_t number, Stated& stated, Service& service) {
  const bool must_tell = stated.is_in_force || stated.is_awaited;
  auto identity = std::is_same_v<Stated, StatedSubscription> ? resolver_.resolve_asked(stated.named)
                                                             : resolver_.resolve_offered(stated.named);
  Refusal refusal;
  if (identity) {
    service.identity = std::move(*identity);
    refusal = announcement::check(service);  // full IRIs may be longer than what can be announced
    if (!refusal) refusal = resolver_.check_conditions(service);
  } else {
    refusal = identity.error();
  }
  stated.is_in_force = !refusal;
  stated.is_awaited = is_awaited(refusal);
  if (refusal && must_tell) {
    telling_.tell_gone(session, number, matching::Reason::changed);
    if (!stated.is_awaited) {
      sessions_.refuse(session, number, *refusal);
      work_.add(cost_of_unknown_name);
    }
  }
  return stated.is_in_force;
}

std::vector<announcement::PeerState> OwnServices::announced() const {
  std::vector<announcement::PeerState> peers;
  for (const Session* session : sessions_.peers()) {
    announcement::PeerState peer;
    peer.id = session->peer();
    peer.name = session->name;
    for (const auto& [number, stated] : session->publications) {
      if (stated.is_in_force) peer.publications.push_back({.number = number, .publication = stated.service});
    }
    for (const auto& [number, stated] : session->subscriptions) {
      if (!stated.is_in_force || stated.is_quiet) continue;
      peer.subscriptions.push_back({.number = number, .subscription = stated.service});
      auto& subscription = peer.subscriptions.back().subscription;
      subscription.chosen = matcher_.announced_choice(key_of(*session, number));
      // Where there is no room for it, the others go on computing the choice themselves.
      if (announcement::check(subscription)) subscription.chosen.clear();
    }
    if (!peer.publications.empty() || !peer.subscriptions.empty()) peers.push_back(std::move(peer));
  }
  return peers;
}

}  // namespace geminga::participant
