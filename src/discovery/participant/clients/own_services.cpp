#include "discovery/participant/clients/own_services.hpp"

#include <algorithm>
#include <type_traits>

#include "discovery/announcement/announceable.hpp"

namespace geminga::participant {

ServiceKey OwnServices::key_of(const Session& session, std::uint32_t number) const {
  return ServiceKey{.participant = self_.id, .peer = session.peer(), .number = number};
}

void OwnServices::enter(const Session& session, std::uint32_t number, const StatedPublication& stated,
                        matching::Matcher::Telling) {
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
  is_changed_ |= stated.is_announced();
}

void OwnServices::withdraw(const Session& session, std::uint32_t number, const StatedPublication&,
                           matching::Reason reason) {
  is_changed_ |= matcher_.remove_publication(key_of(session, number), reason);
}

void OwnServices::withdraw(const Session& session, std::uint32_t number, const StatedSubscription& stated,
                           matching::Reason reason) {
  is_changed_ |= matcher_.remove_subscription(key_of(session, number), reason) && stated.is_announced();
}

void OwnServices::forget(Session& session, std::uint32_t number) {
  session.services.with(number,
                        [&](const auto& stated) { withdraw(session, number, stated, matching::Reason::withdrawn); });
  session.forget(number);
}

template <typename Stated>
void OwnServices::suspend(Session& session, std::uint32_t number, const Stated& stated) {
  if (!stated.is_in_force) return;
  telling_.tell_gone(session, number, matching::Reason::changed);
  withdraw(session, number, stated, matching::Reason::changed);
}
template void OwnServices::suspend(Session&, std::uint32_t, const StatedPublication&);
template void OwnServices::suspend(Session&, std::uint32_t, const StatedSubscription&);

bool OwnServices::is_small(const Session& session) const {
  return session.services.count() * sessions_.service_count() <= max_pairs_at_once;
}

void OwnServices::withdraw_all(Session& session) {
  is_changed_ |= session.services.shared_count() > 0;
  matcher_.remove_peer(self_.id, session.peer(), matching::Reason::withdrawn);
  session.services.clear();
  session.told.clear();
  session.resyncs.clear();
  session.to_rename.clear();
}

void OwnServices::withdraw_one(Session& session) {
  if (!session.services.subscriptions.empty()) {
    forget(session, session.services.subscriptions.rbegin()->first);
  } else if (!session.services.publications.empty()) {
    forget(session, session.services.publications.rbegin()->first);
  }
}

void OwnServices::rename(Session& session) {
  session.services.for_each([&](std::uint32_t number, const auto&) { session.to_rename.insert(number); });
  if (!is_small(session)) return;
  while (!session.to_rename.empty()) rename_one(session);
}

void OwnServices::rename_one(Session& session) {
  const std::uint32_t number = *session.to_rename.begin();
  session.to_rename.erase(session.to_rename.begin());
  session.services.with(number, [&](const auto& stated) { enter(session, number, stated); });
}

void OwnServices::list_returning() {
  returning_.clear();
  is_changed_ |= description_.enter();
  for (const auto& [stream, session] : sessions_.all) {
    session->services.for_each(
        [&, at = stream](std::uint32_t number, const auto&) { returning_.push_back({at, number}); });
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
  session->services.with(number, [&, id = number](const auto& stated) {
    enter(*session, id, stated, matching::Matcher::Telling::providers);
    if (stated.is_in_force) session->resyncs[id] = {};
  });
  return true;
}

void OwnServices::list_for_restating(bool is_of_all) {
  restated_.clear();
  is_changed_ |= description_.restate(is_of_all);
  for (const auto& [stream, session] : sessions_.all) {
    session->services.for_each([&, at = stream](std::uint32_t number, const auto& stated) {
      if (is_of_all || stated.is_awaited) restated_.push_back({at, number});
    });
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
  session->services.with(number, [&, id = number](auto& stated) {
    const bool is_known = resolve_again(*session, id, stated);
    if (!self_.is_claimed()) return;
    if (is_known) {
      enter(*session, id, stated);
    } else {
      withdraw(*session, id, stated, matching::Reason::changed);
    }
  });
  return true;
}

/// Sets the identity that the ontology gives to the names. False where it does not know them, or is not prepared for
/// them yet; then the peer was told.
template <typename Stated>
bool OwnServices::resolve_again(Session& session, std::uint32_t number, Stated& stated) {
  const bool must_tell = stated.is_in_force || stated.is_awaited;
  auto identity = resolver_.resolve(stated.named);
  Refusal refusal;
  if (identity) {
    stated.service.identity = std::move(*identity);
    if constexpr (std::is_same_v<Stated, StatedSubscription>) {
      const auto on = stated.service.on.empty() ? "" : resolver_.resolve_on(stated.service.on);
      if (on) stated.service.on = *on;
      if (!on) refusal = on.error();
    }
    if (!refusal) refusal = announcement::check(stated.service);  // full IRIs may be longer than what can be announced
    if (!refusal) refusal = resolver_.check_conditions(stated.service);
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
  if (auto self = description_.announced()) peers.push_back(std::move(*self));
  for (const Session* session : sessions_.peers()) {
    announcement::PeerState peer;
    peer.id = session->peer();
    peer.name = session->name;
    for (const auto& [number, stated] : session->services.publications) {
      if (stated.is_in_force) peer.publications.push_back({.number = number, .publication = stated.service});
    }
    for (const auto& [number, stated] : session->services.subscriptions) {
      if (!stated.is_in_force || !stated.is_announced()) continue;
      peer.subscriptions.push_back({.number = number, .subscription = stated.service});
      auto& subscription = peer.subscriptions.back().subscription;
      subscription.chosen = matcher_.choices().announced(key_of(*session, number));
      // Where there is no room for it, the others go on computing the choice themselves.
      if (announcement::check(subscription)) subscription.chosen.clear();
    }
    if (!peer.publications.empty() || !peer.subscriptions.empty()) peers.push_back(std::move(peer));
  }
  return peers;
}

}  // namespace geminga::participant
