#include "discovery/participant/clients/own_services.hpp"

#include <utility>

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
