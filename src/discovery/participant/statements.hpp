// What a participant does about each statement of a peer; one command a file.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_STATEMENTS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_STATEMENTS_HPP

#include <cstdint>
#include <optional>

#include "discovery/gcnp/request.hpp"
#include "discovery/participant/core.hpp"
#include "geminga/error.hpp"

namespace geminga::participant {

/// The error that the peer is answered, or nothing: silence is success.
using Refusal = std::optional<Error>;

/// Requires that an identifier is held. A refused request has changed nothing.
[[nodiscard]] Refusal handle(Core& core, Session& session, std::uint32_t id, const gcnp::Request& request);

// sys
[[nodiscard]] Refusal on(Core& core, Session& session, const gcnp::Hello& hello);
void on(Core& core, Session& session, const gcnp::Ping& ping);
void on(Core& core, Session& session, const gcnp::Bye& bye);
// pub
[[nodiscard]] Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::PubCreate& create);
[[nodiscard]] Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::PubModify& modify);
[[nodiscard]] Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::PubRemove& remove);
// sub
[[nodiscard]] Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::SubCreate& create);
[[nodiscard]] Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::SubModify& modify);
[[nodiscard]] Refusal on(Core& core, Session& session, std::uint32_t id, const gcnp::SubRemove& remove);

/// What both kinds of `create` ask first: whether the id is free (409).
[[nodiscard]] Refusal check_new(const Session& session, std::uint32_t id);
/// Whether the peer has not too many of a kind already (429).
[[nodiscard]] Refusal check_count(const Core& core, std::size_t of_its_kind);
/// What they ask last, when nothing else is wrong: whether the host has room for one more (429), which may have to be
/// taken from a peer that has more than its share.
[[nodiscard]] Refusal make_room(Core& core, const Session& session);
/// 404 for an id that is nobody's, with a hint where the other command has it.
[[nodiscard]] Error unknown_request(std::uint32_t id, const char* kind, bool is_other_kind);
/// The names of an identity after a `modify`: what is not given stays. 422 for a representation without a concept.
[[nodiscard]] std::expected<NamedIdentity, Error> changed(const NamedIdentity& named, const IdentityChange& change);

}  // namespace geminga::participant

#endif
