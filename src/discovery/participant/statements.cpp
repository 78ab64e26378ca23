#include "discovery/participant/statements.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "discovery/participant/own_services.hpp"
#include "discovery/participant/queries/queries.hpp"

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
        } else if constexpr (requires { begin(core, one); }) {
          return reply(core, session, id, begin(core, one));
        } else {
          auto answered = answer(core, one);
          if (!answered) return std::move(answered.error());
          return reply(core, session, id, telling(std::move(*answered)));
        }
      },
      request);
}

namespace {

/// Takes one service back from the peer that has the most, if that peer then still has at least as many as the one that
/// asks will have. So a peer may use room that is free, and no peer is kept from its fair share. False where no peer
/// has so many more.
bool take_back_one(Core& core, const Session& asking) {
  const auto most = std::ranges::max_element(core.sessions, {}, [](const auto& entry) {
    // What is on its way out goes first.
    return std::pair(entry.second->is_leaving && entry.second->shared_count() > 0, entry.second->shared_count());
  });
  Session& greediest = *most->second;
  if (greediest.is_leaving && greediest.shared_count() > 0) {
    withdraw_one(core, greediest);
    return true;
  }
  if (greediest.shared_count() < asking.shared_count() + 2) return false;
  const auto shared = std::find_if(greediest.subscriptions.rbegin(), greediest.subscriptions.rend(),
                                   [](const auto& entry) { return !entry.second.is_quiet; });
  const std::uint32_t number = std::max(greediest.publications.empty() ? 0 : greediest.publications.rbegin()->first,
                                        shared == greediest.subscriptions.rend() ? 0 : shared->first);
  if (greediest.publications.contains(number)) {
    forget_publication(core, greediest, number);
  } else {
    forget_subscription(core, greediest, number);
  }
  core.refuse(greediest, number,
              {ErrorCode::too_many, "taken back: the peers of one host may have " +
                                        std::to_string(core.settings.limits.services) +
                                        " publications and subscriptions together, and another one has fewer"});
  return true;
}

}  // namespace

Refusal check_new(const Session& session, std::uint32_t id) {
  if (!session.publications.contains(id) && !session.subscriptions.contains(id)) return std::nullopt;
  return Error{ErrorCode::already_exists,
               std::to_string(id) + " is in use already: choose another number, or modify it"};
}

Refusal check_count(const Core& core, std::size_t of_its_kind) {
  const Limits& limits = core.settings.limits;
  if (of_its_kind < limits.services_per_peer) return std::nullopt;
  return Error{ErrorCode::too_many,
               "too many: a peer may have " + std::to_string(limits.services_per_peer) + " of each kind"};
}

Refusal make_room(Core& core, const Session& session) {
  const std::size_t limit = core.settings.limits.services;
  if (core.shared_count() < limit || take_back_one(core, session)) return std::nullopt;
  return Error{ErrorCode::too_many, "too many: the peers of one host may have " + std::to_string(limit) +
                                        " publications and subscriptions together"};
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
