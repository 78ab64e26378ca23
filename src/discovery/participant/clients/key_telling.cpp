#include "discovery/participant/clients/key_telling.hpp"

#include "discovery/gcnp/life.hpp"

namespace geminga::participant {

bool KeyTelling::ask(Session& session, bool asks) {
  const bool is_new = asks && !session.asks_for_keys;
  session.asks_for_keys = asks;
  if (is_new) begin_anew(session);
  return !keys_of_(no_life).ring.empty();
}

void KeyTelling::tell(Session& session, std::uint32_t request, const Attributes& attributes) {
  if (!session.asks_for_keys) return;
  const Life life = gcnp::stated_life(attributes);
  if (life == no_life || session.channels_told.contains({request, life})) return;
  const gcnp::ChannelKeyring keyring = keys_of_(life);
  // A client that was never given a key takes its channels for plain.
  if (keyring.ring.empty() && !session.has_keys) return;
  session.has_keys = true;
  if (session.channels_told.size() == max_told_channels) session.channels_told.clear();
  session.channels_told.emplace(request, life);
  work_.add(cost_of_event);
  session.say(gcnp::to_statement(request, keyring));
}

void KeyTelling::change() {
  for (const auto& [stream, session] : sessions_.all) {
    if (!session->asks_for_keys || session->is_leaving) continue;
    session->say(gcnp::Statement{.id = 0, .command = "msg", .subcommand = "sealing", .parameters = {{"mode", mode()}}});
    begin_anew(*session);
  }
}

void KeyTelling::begin_anew(Session& session) {
  session.channels_told.clear();
  session.for_each_request([&](std::uint32_t number, const auto& stated) {
    if (stated.is_in_force) session.resyncs[number] = {};
  });
}

}  // namespace geminga::participant
