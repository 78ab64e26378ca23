#include "participant/statements.hpp"

#include <type_traits>
#include <utility>

#include "participant/queries/queries.hpp"

namespace geminga::participant {

Refusal handle(Core& core, Session& session, std::uint32_t id, const gcnp::Request& request) {
  return std::visit(
      [&](const auto& one) -> Refusal {
        using Kind = std::decay_t<decltype(one)>;
        if constexpr (std::is_same_v<Kind, gcnp::Hello>) {
          return on(core, session, one);
        } else if constexpr (std::is_same_v<Kind, gcnp::Ping> || std::is_same_v<Kind, gcnp::Bye>) {
          on(core, session, one);
          return std::nullopt;
        } else if constexpr (requires { on(core, session, id, one); }) {
          return on(core, session, id, one);
        } else {
          return reply(session, id, answer(core, one));
        }
      },
      request);
}

Refusal check_room(const Core& core, const Session& session, std::uint32_t id, std::size_t of_its_kind) {
  if (session.publications.contains(id) || session.subscriptions.contains(id)) {
    return Error{ErrorCode::already_exists,
                 std::to_string(id) + " is in use already: choose another number, or modify it"};
  }
  const Limits& limits = core.settings.limits;
  if (of_its_kind >= limits.services_per_peer) {
    return Error{ErrorCode::too_many,
                 "too many: a peer may have " + std::to_string(limits.services_per_peer) + " of each kind"};
  }
  if (core.service_count() >= limits.services) {
    return Error{ErrorCode::too_many, "too many: the peers of one host may have " + std::to_string(limits.services) +
                                          " publications and subscriptions together"};
  }
  return std::nullopt;
}

Error unknown_request(std::uint32_t id, const char* kind, bool is_other_kind) {
  return Error{ErrorCode::unknown_request,
               "there is no " + std::string(kind) + " " + std::to_string(id) +
                   (is_other_kind ? ": that number is of the other kind" : ": create it first")};
}

std::expected<NamedIdentity, Error> changed(const NamedIdentity& named, const IdentityChange& change) {
  if (const auto* number = std::get_if<NumericIdentity>(&change)) return *number;
  if (const auto* text = std::get_if<TextIdentity>(&change)) return *text;
  const auto& names = std::get<ConceptChange>(change);
  const auto* before = std::get_if<ConceptNames>(&named);
  if (before == nullptr && !names.concept_name) {
    return std::unexpected(
        Error{ErrorCode::impossible, "representation: the identity has no concept: give concept= too"});
  }
  ConceptNames after = before == nullptr ? ConceptNames{} : *before;
  if (names.concept_name) after.concept_name = *names.concept_name;
  if (names.representation_name) after.representation_name = *names.representation_name;
  return after;
}

}  // namespace geminga::participant
