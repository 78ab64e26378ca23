// `N sub create`, `modify` and `remove`.
#include <utility>

#include "discovery/announcement/announceable.hpp"
#include "discovery/matching/scope.hpp"
#include "discovery/participant/conditions.hpp"
#include "discovery/participant/identities.hpp"
#include "discovery/participant/own_services.hpp"
#include "discovery/participant/statements.hpp"

namespace geminga::participant {
namespace {

/// What must hold of a subscription beside what its statement says by itself.
Refusal check(const Subscription& subscription) {
  if (auto refusal = announcement::check(subscription)) return refusal;
  return matching::check_scope(subscription.scope);
}

/// The same of its conditions and wishes, which may have to wait.
Refusal check_conditions(const Core& core, StatedSubscription& stated) {
  auto refusal = check_conditions(core, stated.subscription);
  if (!is_awaited(refusal)) return refusal;
  stated.is_in_force = false;
  stated.is_awaited = true;
  return std::nullopt;
}

/// Whether it has a place of the room that its peer asked for: the others need not know who listens to a stream.
bool is_quiet(const Session& session, ChannelMode mode) {
  return session.room > 0 && mode == ChannelMode::one_to_many_stream;
}

/// Whether the peer may have one more of these.
Refusal check_place(const Core& core, const Session& session, bool is_quiet) {
  if (!is_quiet) return check_count(core, session.subscriptions.size() - session.quiet);
  if (session.quiet < session.room) return std::nullopt;
  return Error{ErrorCode::too_many, "too many: this peer has asked for room for " + std::to_string(session.room) +
                                        " subscriptions of mode otm/stream"};
}

/// The limit where none is stated: one provider for a channel between two, every one otherwise.
std::uint32_t default_limit(ChannelMode mode) { return mode == ChannelMode::one_to_one ? 1 : 0; }

}  // namespace

Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::SubCreate& create) {
  if (auto refusal = check_new(session, id)) return refusal;
  const bool takes_room = is_quiet(session, create.subscription.mode);
  if (auto refusal = check_place(core, session, takes_room)) return refusal;
  auto identity = resolve_asked(core, create.subscription.identity);
  const bool must_wait = is_awaited(core, identity);
  if (!identity && !must_wait) return identity.error();
  StatedSubscription stated{.named = create.subscription.identity,
                            .subscription = gcnp::with_identity(create.subscription, {}),
                            .has_limit = create.subscription.limit.has_value(),
                            .is_quiet = takes_room,
                            .is_in_force = !must_wait,
                            .is_awaited = must_wait};
  if (identity) stated.subscription.identity = std::move(*identity);
  if (auto refusal = check(stated.subscription)) return refusal;
  if (auto refusal = check_conditions(core, stated)) return refusal;
  if (auto refusal = takes_room ? std::nullopt : make_room(core, session)) return refusal;
  session.quiet += takes_room ? 1 : 0;
  // All that it is given is told piece by piece, however much that is.
  enter(core, session, id, session.subscriptions.emplace(id, std::move(stated)).first->second,
        matching::Matcher::Telling::providers);
  if (session.subscriptions.at(id).is_in_force) session.pictures[id] = {};
  return std::nullopt;
}

Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::SubModify& modify) {
  const auto found = session.subscriptions.find(id);
  if (found == session.subscriptions.end()) {
    return unknown_request(id, "subscription", session.publications.contains(id));
  }
  StatedSubscription stated = found->second;
  gcnp::apply(modify, stated.subscription);
  stated.has_limit |= modify.limit.has_value();
  if (!stated.has_limit) stated.subscription.limit = default_limit(stated.subscription.mode);
  if (modify.identity) {
    auto named = changed(stated.named, *modify.identity);
    if (!named) return named.error();
    stated.named = std::move(*named);
  }
  auto identity = resolve_asked(core, stated.named);
  const bool must_wait = is_awaited(core, identity);
  if (!identity && !must_wait) return identity.error();
  if (identity) stated.subscription.identity = std::move(*identity);
  stated.is_in_force = !must_wait;
  stated.is_awaited = must_wait;
  if (auto refusal = check(stated.subscription)) return refusal;
  if (auto refusal = check_conditions(core, stated)) return refusal;
  if (stated.is_quiet && !is_quiet(session, stated.subscription.mode)) {
    if (auto refusal = check_place(core, session, false)) return refusal;
    if (auto refusal = make_room(core, session)) return refusal;
    stated.is_quiet = false;
    --session.quiet;
    core.is_changed = true;
  }
  if (stated.is_awaited) suspend(core, session, id, found->second);
  found->second = std::move(stated);
  enter(core, session, id, found->second);
  return std::nullopt;
}

Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::SubRemove&) {
  if (!session.subscriptions.contains(id)) {
    return unknown_request(id, "subscription", session.publications.contains(id));
  }
  forget_subscription(core, session, id);
  return std::nullopt;
}

}  // namespace geminga::participant
