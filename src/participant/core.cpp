#include "participant/core.hpp"

#include <algorithm>
#include <utility>

#include "base/assert.hpp"
#include "el/ontology.hpp"
#include "gcnp/event.hpp"
#include "participant/naming.hpp"

namespace geminga::participant {
namespace {

Change public_change(matching::Change change) {
  switch (change) {
    case matching::Change::add:
      return Change::add;
    case matching::Change::modify:
      return Change::modify;
    case matching::Change::del:
      return Change::del;
  }
  return Change::del;
}

ServiceEvent service_event(const el::Ontology* ontology, const matching::Event& event,
                           const registry::PublicationEntry& about) {
  ServiceEvent told;
  told.change = public_change(event.change);
  told.service = about.key;
  if (event.change == matching::Change::del) {
    told.reason = to_string(event.reason);
    return told;
  }
  told.peer_name = about.peer_name;
  told.participant_name = about.participant_name;
  told.publication = named(ontology, about.publication);
  told.degree = event.match.degree;
  told.distance = event.match.distance;
  return told;
}

ConsumerEvent consumer_event(const el::Ontology* ontology, const matching::Event& event,
                             const registry::SubscriptionEntry& about) {
  ConsumerEvent told;
  told.change = public_change(event.change);
  told.subscription = about.key;
  if (event.change == matching::Change::del) {
    told.reason = to_string(event.reason);
    return told;
  }
  told.peer_name = about.peer_name;
  told.participant_name = about.participant_name;
  told.subscribed = named(ontology, about.subscription);
  told.degree = event.match.degree;
  told.distance = event.match.distance;
  return told;
}

ServiceKey key_of(const matching::Event& event) {
  return std::visit([](const auto& about) { return about.key; }, event.about);
}

/// A name that was looked for in vain was compared with many.
constexpr std::size_t statements_per_impossible = 40;

}  // namespace

std::string_view to_string(Phase phase) {
  switch (phase) {
    case Phase::created:
      return "created";
    case Phase::claiming:
      return "claiming";
    case Phase::ready:
      return "ready";
    case Phase::stopping:
      return "stopping";
    case Phase::stopped:
      return "stopped";
    case Phase::failed:
      return "failed";
  }
  return "failed";
}

Core::Core(env::Env& the_env, Settings the_settings, const el::Ontology* the_ontology)
    : env(the_env),
      settings(std::move(the_settings)),
      ontology(the_ontology),
      expressions(the_ontology),
      matcher(the_ontology,
              [this](const std::string& expression, ParticipantId from) {
                const bool is_own = from == ParticipantId{} || from == id;
                return expressions.place(expression, is_own ? std::nullopt : std::optional(from), env.now());
              }),
      neighbours(settings.group) {}

std::string Core::name() const { return settings.name.empty() ? to_string(id) : settings.name; }

std::uint64_t Core::digest() const { return ontology == nullptr ? 0 : ontology->digest(); }

Session* Core::find(PeerId peer) {
  const auto found = std::ranges::find(sessions, peer, [](const auto& entry) { return entry.second->peer(); });
  return found == sessions.end() ? nullptr : found->second.get();
}

std::vector<const Session*> Core::peers() const {
  std::vector<const Session*> peers;
  for (const auto& [stream, session] : sessions) peers.push_back(session.get());
  std::ranges::sort(peers, {}, &Session::peer);
  return peers;
}

const env::Interface* Core::find(env::InterfaceIndex index) const {
  const auto& interfaces = env.interfaces();
  const auto found = std::ranges::find(interfaces, index, &env::Interface::index);
  return found == interfaces.end() ? nullptr : &*found;
}

std::size_t Core::service_count() const {
  std::size_t count = 0;
  for (const auto& [stream, session] : sessions) count += session->publications.size() + session->subscriptions.size();
  return count;
}

void Core::refuse(Session& session, std::uint32_t statement, const Error& error) {
  ++counters.errors;
  if (error.code == ErrorCode::impossible) session.gate.charge(statements_per_impossible);
  session.say(statement, error);
}

void Core::deliver_events() {
  for (const matching::Event& event : matcher.take_events()) {
    Session* session = find(event.to.peer);
    if (session == nullptr) continue;  // Its peer has gone, and with it whom this was for.
    if (event.change == matching::Change::del) {
      session->told[event.to.number].erase(key_of(event));
    } else {
      session->told[event.to.number].insert(key_of(event));
    }
    ++counters.events;
    session->say(std::visit(
        [&](const auto& about) {
          if constexpr (std::is_same_v<std::decay_t<decltype(about)>, registry::PublicationEntry>) {
            return gcnp::to_statement(event.to.number, service_event(ontology, event, about));
          } else {
            return gcnp::to_statement(event.to.number, consumer_event(ontology, event, about));
          }
        },
        event.about));
  }
}

}  // namespace geminga::participant
