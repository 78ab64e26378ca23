// `0 sys hello`, `ping` and `bye`.
#include "base/text.hpp"
#include "discovery/announcement/announceable.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/participant/naming.hpp"
#include "discovery/participant/own_services.hpp"
#include "discovery/participant/statements.hpp"

namespace geminga::participant {
namespace {

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

/// Promises room that the peer will need, beside what all peers share.
Refusal promise_room(Core& core, Session& session, std::size_t room) {
  const Limits& limits = core.settings.limits;
  if (room > limits.room_per_peer) {
    return Error{ErrorCode::too_large,
                 "room: " + std::to_string(room) + ", the limit is " + std::to_string(limits.room_per_peer)};
  }
  if (room != session.room && !session.subscriptions.empty()) {
    return Error{ErrorCode::impossible, "room: say it before the first subscription"};
  }
  if (core.promised_room() - session.room + room > limits.room) {
    return Error{ErrorCode::too_many, "room: the peers of one host may ask for " + std::to_string(limits.room) +
                                          " together, and other ones have the rest"};
  }
  session.room = room;
  return std::nullopt;
}

/// Tells everybody who knows this peer its new name, one service after the other where they are many.
void rename(Core& core, Session& session, const std::string& name) {
  session.name = name;
  for (const auto& [number, stated] : session.publications) session.to_rename.insert(number);
  for (const auto& [number, stated] : session.subscriptions) session.to_rename.insert(number);
  if (!is_small(core, session)) return;
  while (!session.to_rename.empty()) rename_one(core, session);
}

}  // namespace

Refusal on(Core& core, Session& session, const gcnp::Hello& hello) {
  if (auto refusal = hello.name ? check_name(*hello.name) : std::nullopt) return refusal;
  if (auto refusal = hello.room ? promise_room(core, session, *hello.room) : std::nullopt) return refusal;
  if (hello.name && *hello.name != session.name) rename(core, session, *hello.name);
  gcnp::Statement answer{.id = 0,
                         .command = "msg",
                         .subcommand = "hello",
                         .parameters = {{"version", "1"},
                                        {"participant", to_string(core.id)},
                                        {"peer", std::to_string(static_cast<std::uint32_t>(session.peer()))},
                                        {"name", session.name},
                                        {"ontology", digest_word(core.digest())},
                                        {"participant_name", core.name()}}};
  if (session.room > 0) answer.parameters.push_back({"room", std::to_string(session.room)});
  session.say(answer);
  return std::nullopt;
}

void on(Core&, Session& session, const gcnp::Ping&) {
  session.say(gcnp::Statement{.id = 0, .command = "msg", .subcommand = "pong", .parameters = {}});
}

void on(Core&, Session& session, const gcnp::Bye&) {
  session.says_bye = true;
  session.is_closing = true;
}

}  // namespace geminga::participant
