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
  if (hello.name) {
    if (auto refusal = check_name(*hello.name)) return refusal;
    if (*hello.name != session.name) rename(core, session, *hello.name);
  }
  session.say(gcnp::Statement{.id = 0,
                              .command = "msg",
                              .subcommand = "hello",
                              .parameters = {{"version", "1"},
                                             {"participant", to_string(core.id)},
                                             {"peer", std::to_string(static_cast<std::uint32_t>(session.peer()))},
                                             {"name", session.name},
                                             {"ontology", digest_word(core.digest())},
                                             {"participant_name", core.name()}}});
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
