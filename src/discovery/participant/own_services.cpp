#include "discovery/participant/own_services.hpp"

#include <algorithm>
#include <type_traits>

#include "discovery/announcement/announceable.hpp"
#include "discovery/participant/conditions.hpp"
#include "discovery/participant/identities.hpp"
#include "discovery/participant/naming.hpp"
#include "discovery/participant/telling.hpp"

namespace geminga::participant {
namespace {

ServiceKey key_of(const Core& core, const Session& session, std::uint32_t number) {
  return ServiceKey{.participant = core.id, .peer = session.peer(), .number = number};
}

/// Sets the identity that the ontology gives to the names. False where it does not know them, or is not prepared for
/// them yet; then the peer was told.
template <typename Stated, typename Service>
bool resolve_again(Core& core, Session& session, std::uint32_t number, Stated& stated, Service& service) {
  const bool must_tell = stated.is_in_force || stated.is_awaited;
  auto identity = std::is_same_v<Stated, StatedSubscription> ? resolve_asked(core, stated.named)
                                                             : resolve_offered(core, stated.named);
  std::optional<Error> refusal;
  if (identity) {
    service.identity = std::move(*identity);
    refusal = announcement::check(service);  // full IRIs may be longer than what can be announced
    if (!refusal) refusal = check_conditions(core, service);
  } else {
    refusal = identity.error();
  }
  stated.is_in_force = !refusal;
  stated.is_awaited = refusal && refusal->code == ErrorCode::not_ready;
  if (refusal && must_tell) {
    tell_gone(core, session, number, matching::Reason::changed);
    if (!stated.is_awaited) core.refuse(session, number, *refusal);
    if (!stated.is_awaited) core.worked += cost_of_unknown_name;
  }
  return stated.is_in_force;
}

}  // namespace

void enter(Core& core, const Session& session, std::uint32_t number, const StatedPublication& stated) {
  if (!stated.is_in_force) return;
  registry::PublicationEntry entry{.key = key_of(core, session, number),
                                   .publication = stated.publication,
                                   .peer_name = session.name,
                                   .participant_name = core.name(),
                                   .is_local = true,
                                   .updated = core.env.now()};
  if (entry.publication.address.empty()) entry.publication.address = local_address;
  core.matcher.put(std::move(entry));
  core.is_changed = true;
}

void enter(Core& core, const Session& session, std::uint32_t number, const StatedSubscription& stated,
           matching::Matcher::Telling telling) {
  if (!stated.is_in_force) return;
  registry::SubscriptionEntry entry{.key = key_of(core, session, number),
                                    .subscription = stated.subscription,
                                    .peer_name = session.name,
                                    .participant_name = core.name(),
                                    .is_local = true,
                                    .updated = core.env.now()};
  if (entry.subscription.address.empty()) entry.subscription.address = local_address;
  core.matcher.put(std::move(entry), telling);
  core.is_changed |= !stated.is_quiet;
}

void withdraw_publication(Core& core, const Session& session, std::uint32_t number, matching::Reason reason) {
  core.is_changed |= core.matcher.remove_publication(key_of(core, session, number), reason);
}

void withdraw_subscription(Core& core, const Session& session, std::uint32_t number, matching::Reason reason) {
  const auto stated = session.subscriptions.find(number);
  const bool is_quiet = stated != session.subscriptions.end() && stated->second.is_quiet;
  core.is_changed |= core.matcher.remove_subscription(key_of(core, session, number), reason) && !is_quiet;
}

void forget_publication(Core& core, Session& session, std::uint32_t number) {
  withdraw_publication(core, session, number, matching::Reason::withdrawn);
  session.publications.erase(number);
  session.told.erase(number);
  session.pictures.erase(number);
  session.to_rename.erase(number);
}

void forget_subscription(Core& core, Session& session, std::uint32_t number) {
  withdraw_subscription(core, session, number, matching::Reason::withdrawn);
  session.quiet -= session.subscriptions.at(number).is_quiet ? 1 : 0;
  session.subscriptions.erase(number);
  session.told.erase(number);
  session.pictures.erase(number);
  session.to_rename.erase(number);
}

bool is_small(const Core& core, const Session& session) {
  return session.service_count() * core.service_count() <= max_pairs_at_once;
}

void suspend(Core& core, Session& session, std::uint32_t number, const StatedPublication& stated) {
  if (!stated.is_in_force) return;
  tell_gone(core, session, number, matching::Reason::changed);
  withdraw_publication(core, session, number, matching::Reason::changed);
}

void suspend(Core& core, Session& session, std::uint32_t number, const StatedSubscription& stated) {
  if (!stated.is_in_force) return;
  tell_gone(core, session, number, matching::Reason::changed);
  withdraw_subscription(core, session, number, matching::Reason::changed);
}

void withdraw_all(Core& core, Session& session) {
  core.is_changed |= session.shared_count() > 0;
  core.matcher.remove_peer(core.id, session.peer(), matching::Reason::withdrawn);
  session.publications.clear();
  session.subscriptions.clear();
  session.quiet = 0;
  session.told.clear();
  session.pictures.clear();
  session.to_rename.clear();
}

void withdraw_one(Core& core, Session& session) {
  if (!session.subscriptions.empty()) {
    forget_subscription(core, session, session.subscriptions.rbegin()->first);
  } else if (!session.publications.empty()) {
    forget_publication(core, session, session.publications.rbegin()->first);
  }
}

void rename_one(Core& core, Session& session) {
  const std::uint32_t number = *session.to_rename.begin();
  session.to_rename.erase(session.to_rename.begin());
  const auto publication = session.publications.find(number);
  if (publication != session.publications.end() && publication->second.is_in_force) {
    enter(core, session, number, publication->second);
  }
  const auto subscription = session.subscriptions.find(number);
  if (subscription != session.subscriptions.end() && subscription->second.is_in_force) {
    enter(core, session, number, subscription->second);
  }
}

void change_identifier(Core& core, ParticipantId held) {
  core.matcher.begin_departure(core.id, matching::Reason::renamed);
  core.id = held;
  core.returning.clear();
  for (const auto& [stream, session] : core.sessions) {
    for (const auto& [number, stated] : session->publications) core.returning.emplace_back(stream, number);
    for (const auto& [number, stated] : session->subscriptions) core.returning.emplace_back(stream, number);
  }
  std::ranges::reverse(core.returning);
}

void return_one(Core& core, Session& session, std::uint32_t number) {
  tell_gone(core, session, number, matching::Reason::renamed);
  if (const auto one = session.publications.find(number); one != session.publications.end()) {
    enter(core, session, number, one->second);
    if (one->second.is_in_force) session.pictures[number] = {};
  }
  if (const auto one = session.subscriptions.find(number); one != session.subscriptions.end()) {
    enter(core, session, number, one->second, matching::Matcher::Telling::providers);
    if (one->second.is_in_force) session.pictures[number] = {};
  }
}

void restate(Core& core, Session& session, std::uint32_t number) {
  core.worked += cost_of_statement;
  const bool is_held = core.phase == Phase::ready;
  if (const auto one = session.publications.find(number); one != session.publications.end()) {
    StatedPublication& stated = one->second;
    const bool knows = resolve_again(core, session, number, stated, stated.publication);
    if (is_held && knows) enter(core, session, number, stated);
    if (is_held && !knows) withdraw_publication(core, session, number, matching::Reason::changed);
  }
  if (const auto one = session.subscriptions.find(number); one != session.subscriptions.end()) {
    StatedSubscription& stated = one->second;
    const bool knows = resolve_again(core, session, number, stated, stated.subscription);
    if (is_held && knows) enter(core, session, number, stated);
    if (is_held && !knows) withdraw_subscription(core, session, number, matching::Reason::changed);
  }
}

}  // namespace geminga::participant
