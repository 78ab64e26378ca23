// `N pub create`, `modify` and `remove`.
#include <utility>

#include "discovery/announcement/announceable.hpp"
#include "discovery/matching/converter.hpp"
#include "discovery/matching/scope.hpp"
#include "discovery/participant/conditions.hpp"
#include "discovery/participant/identities.hpp"
#include "discovery/participant/own_services.hpp"
#include "discovery/participant/statements.hpp"

namespace geminga::participant {
namespace {

/// What must hold of a publication beside what its statement says by itself.
Refusal check(const Core& core, const Publication& publication) {
  if (auto refusal = announcement::check(publication)) return refusal;
  if (auto refusal = matching::check_scope(publication.scope)) return refusal;
  return matching::check_conversion(publication.attributes, core.vocabulary());
}

/// The same of its condition, which may have to wait.
Refusal check_conditions(const Core& core, StatedPublication& stated) {
  auto refusal = check_conditions(core, stated.publication);
  if (!is_awaited(refusal)) return refusal;
  stated.is_in_force = false;
  stated.is_awaited = true;
  return std::nullopt;
}

}  // namespace

Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::PubCreate& create) {
  if (auto refusal = check_new(session, id)) return refusal;
  if (auto refusal = check_count(core, session.publications.size())) return refusal;
  auto identity = resolve_offered(core, create.publication.identity);
  const bool must_wait = is_awaited(core, identity);
  if (!identity && !must_wait) return identity.error();
  StatedPublication stated{.named = create.publication.identity,
                           .publication = gcnp::with_identity(create.publication, {}),
                           .is_in_force = !must_wait,
                           .is_awaited = must_wait};
  if (identity) stated.publication.identity = std::move(*identity);
  if (auto refusal = check(core, stated.publication)) return refusal;
  if (auto refusal = check_conditions(core, stated)) return refusal;
  if (auto refusal = make_room(core, session)) return refusal;
  enter(core, session, id, session.publications.emplace(id, std::move(stated)).first->second);
  return std::nullopt;
}

Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::PubModify& modify) {
  const auto found = session.publications.find(id);
  if (found == session.publications.end())
    return unknown_request(id, "publication", session.subscriptions.contains(id));
  StatedPublication stated = found->second;
  gcnp::apply(modify, stated.publication);
  if (modify.identity) {
    auto named = changed(stated.named, *modify.identity);
    if (!named) return named.error();
    stated.named = std::move(*named);
  }
  auto identity = resolve_offered(core, stated.named);
  const bool must_wait = is_awaited(core, identity);
  if (!identity && !must_wait) return identity.error();
  if (identity) stated.publication.identity = std::move(*identity);
  stated.is_in_force = !must_wait;
  stated.is_awaited = must_wait;
  if (auto refusal = check(core, stated.publication)) return refusal;
  if (auto refusal = check_conditions(core, stated)) return refusal;
  if (stated.is_awaited) suspend(core, session, id, found->second);
  found->second = std::move(stated);
  enter(core, session, id, found->second);
  return std::nullopt;
}

Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::PubRemove&) {
  if (!session.publications.contains(id)) return unknown_request(id, "publication", session.subscriptions.contains(id));
  forget_publication(core, session, id);
  return std::nullopt;
}

}  // namespace geminga::participant
