#include "discovery/participant/clients/statements.hpp"

#include <string>
#include <type_traits>

#include "base/text.hpp"
#include "discovery/announcement/announceable.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/participant/knowledge/naming.hpp"

namespace geminga::participant {
namespace {

/// 404 for an id that is nobody's, with a hint where the other command has it.
Error unknown_request(std::uint32_t id, const char* kind, bool is_other_kind) {
  return Error{ErrorCode::unknown_request,
               "there is no " + std::string(kind) + " " + std::to_string(id) +
                   (is_other_kind ? ": that number is of the other kind" : ": create it first")};
}

/// The names of an identity after a `modify`: what is not given stays. 422 for a representation without a concept.
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

template <typename Modify, typename Stated>
Refusal change_names(const Modify& modify, Stated& stated) {
  if (!modify.identity) return std::nullopt;
  auto named = changed(stated.named, *modify.identity);
  if (!named) return named.error();
  stated.named = std::move(*named);
  return std::nullopt;
}

/// Whether a subscription takes a place of the room that its peer asked for: the others need not know who listens to a
/// stream.
bool is_quiet(const Session& session, ChannelMode mode) {
  return session.services.room > 0 && mode == ChannelMode::one_to_many_stream;
}

/// The limit where none is stated: one provider for a channel between two, every one otherwise.
std::uint32_t default_limit(ChannelMode mode) { return mode == ChannelMode::one_to_one ? 1 : 0; }

Refusal check_name(const std::string& name) {
  if (name.size() > max_name_bytes) {
    return Error{ErrorCode::too_large,
                 "name: " + std::to_string(name.size()) + " octets, the limit is " + std::to_string(max_name_bytes)};
  }
  if (!announcement::is_valid_name(name)) {
    return Error{ErrorCode::malformed,
                 "name=" + base::printable(name) + ": a name is not empty and has no control character, '/' or ','"};
  }
  return std::nullopt;
}

}  // namespace

Refusal Statements::handle(Session& session, std::uint32_t id, const gcnp::Request& request) {
  return std::visit(
      [&](const auto& one) -> Refusal {
        using One = std::decay_t<decltype(one)>;
        if constexpr (std::is_same_v<One, gcnp::Ping>) {
          session.say(gcnp::Statement{.id = 0, .command = "msg", .subcommand = "pong", .parameters = {}});
          return std::nullopt;
        } else if constexpr (std::is_same_v<One, gcnp::Bye>) {
          session.says_bye = true;
          session.is_closing = true;
          return std::nullopt;
        } else if constexpr (requires { on(session, id, one); }) {
          return on(session, id, one);
        } else {
          auto answering = ask_(request);
          if (!answering) return std::move(answering.error());
          begin_answer(session, work_, id, std::move(*answering));
          return std::nullopt;
        }
      },
      request);
}

Refusal Statements::on(Session& session, std::uint32_t, const gcnp::Hello& hello) {
  if (auto refusal = hello.name ? check_name(*hello.name) : std::nullopt) return refusal;
  if (auto refusal = hello.room ? admission_.promise_room(session, *hello.room) : std::nullopt) return refusal;
  if (hello.name && *hello.name != session.name) {
    session.name = *hello.name;
    own_.rename(session);
  }
  session.say(greeting_.answer(session, hello));
  return std::nullopt;
}

Refusal Statements::on(Session&, std::uint32_t, const gcnp::Describe& describe) {
  const bool is_new = describe.concept_name && !describe.concept_name->empty() && own_.description().count() == 0;
  if (auto refusal = is_new ? admission_.check_room() : std::nullopt) return refusal;
  return own_.describe(describe);
}

Refusal Statements::on(Session& session, std::uint32_t id, const gcnp::PubCreate& create) {
  if (auto refusal = Admission::check_new(session, id)) return refusal;
  if (auto refusal = admission_.check_publications(session)) return refusal;
  StatedPublication stated{.named = create.publication.identity,
                           .service = gcnp::with_identity(create.publication, {})};
  if (auto refusal = names_.resolve(stated)) return refusal;
  if (auto refusal = admission_.make_room(session)) return refusal;
  const StatedPublication& entered = session.services.publications.emplace(id, std::move(stated)).first->second;
  keys_.tell(session, id, entered.service.attributes);
  own_.enter(session, id, entered);
  return std::nullopt;
}

Refusal Statements::on(Session& session, std::uint32_t id, const gcnp::PubModify& modify) {
  const auto found = session.services.publications.find(id);
  if (found == session.services.publications.end())
    return unknown_request(id, "publication", session.services.subscriptions.contains(id));
  StatedPublication stated = found->second;
  gcnp::apply(modify, stated.service);
  if (auto refusal = change_names(modify, stated)) return refusal;
  if (auto refusal = names_.resolve(stated)) return refusal;
  if (stated.is_awaited) own_.suspend(session, id, found->second);
  found->second = std::move(stated);
  keys_.tell(session, id, found->second.service.attributes);
  own_.enter(session, id, found->second);
  return std::nullopt;
}

Refusal Statements::on(Session& session, std::uint32_t id, const gcnp::PubRemove&) {
  if (!session.services.publications.contains(id))
    return unknown_request(id, "publication", session.services.subscriptions.contains(id));
  own_.forget(session, id);
  return std::nullopt;
}

Refusal Statements::on(Session& session, std::uint32_t id, const gcnp::SubCreate& create) {
  if (auto refusal = Admission::check_new(session, id)) return refusal;
  const bool takes_room = is_quiet(session, create.subscription.mode);
  if (auto refusal = admission_.check_subscriptions(session, takes_room)) return refusal;
  StatedSubscription stated{.named = create.subscription.identity,
                            .service = gcnp::with_identity(create.subscription, {}),
                            .has_limit = create.subscription.limit.has_value(),
                            .is_quiet = takes_room};
  if (auto refusal = names_.resolve(stated)) return refusal;
  if (auto refusal = takes_room ? std::nullopt : admission_.make_room(session)) return refusal;
  session.services.quiet += takes_room ? 1 : 0;
  // All that it is given is told piece by piece, however much that is.
  own_.enter(session, id, session.services.subscriptions.emplace(id, std::move(stated)).first->second,
             matching::Matcher::Telling::providers);
  if (session.services.subscriptions.at(id).is_in_force) session.resyncs[id] = {};
  return std::nullopt;
}

Refusal Statements::on(Session& session, std::uint32_t id, const gcnp::SubModify& modify) {
  const auto found = session.services.subscriptions.find(id);
  if (found == session.services.subscriptions.end()) {
    return unknown_request(id, "subscription", session.services.publications.contains(id));
  }
  StatedSubscription stated = found->second;
  gcnp::apply(modify, stated.service);
  stated.has_limit |= modify.limit.has_value();
  if (!stated.has_limit) stated.service.limit = default_limit(stated.service.mode);
  if (auto refusal = change_names(modify, stated)) return refusal;
  if (auto refusal = names_.resolve(stated)) return refusal;
  if (stated.is_quiet && !is_quiet(session, stated.service.mode)) {
    if (auto refusal = admission_.check_subscriptions(session, false)) return refusal;
    if (auto refusal = admission_.make_room(session)) return refusal;
    stated.is_quiet = false;
    --session.services.quiet;
    own_.change();
  }
  if (stated.is_awaited) own_.suspend(session, id, found->second);
  found->second = std::move(stated);
  own_.enter(session, id, found->second);
  return std::nullopt;
}

Refusal Statements::on(Session& session, std::uint32_t id, const gcnp::SubRemove&) {
  if (!session.services.subscriptions.contains(id)) {
    return unknown_request(id, "subscription", session.services.publications.contains(id));
  }
  own_.forget(session, id);
  return std::nullopt;
}

}  // namespace geminga::participant
