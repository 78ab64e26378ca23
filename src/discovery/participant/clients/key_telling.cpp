#include "discovery/participant/clients/key_telling.hpp"

#include "discovery/gcnp/life.hpp"

namespace geminga::participant {

bool KeyTelling::ask(Session& session, bool asks) {
  if (session.keys.ask(asks)) begin_anew(session);
  return !keys_of_(no_life).ring.empty();
}

void KeyTelling::tell(Session& session, std::uint32_t request, const Attributes& attributes) {
  if (!session.keys.is_asked_for()) return;
  const Life life = gcnp::stated_life(attributes);
  if (life == no_life || session.keys.has(request, life)) return;
  const gcnp::ChannelKeyring keyring = keys_of_(life);
  // A client that was never given a key takes its channels for plain.
  if (keyring.ring.empty() && !session.keys.has_any()) return;
  session.keys.add(request, life);
  work_.add(cost_of_event);
  session.say(gcnp::to_statement(request, keyring));
}

void KeyTelling::change() {
  for (const auto& [stream, session] : sessions_.all) {
    if (!session->keys.is_asked_for() || session->is_leaving) continue;
    session->say(gcnp::Statement{.id = 0, .command = "msg", .subcommand = "sealing", .parameters = {{"mode", mode()}}});
    begin_anew(*session);
  }
}

void KeyTelling::begin_anew(Session& session) {
  session.keys.clear();
  session.services.for_each([&](std::uint32_t number, const auto& stated) {
    if (stated.is_in_force) session.resyncs[number] = {};
  });
}

}  // namespace geminga::participant
