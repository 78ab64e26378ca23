#include "discovery/participant/core.hpp"

#include <algorithm>
#include <utility>

#include "base/assert.hpp"
#include "discovery/participant/naming.hpp"

namespace geminga::participant {
namespace {

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

Core::Core(env::Env& the_env, Settings the_settings, vocabulary::Vocabulary the_vocabulary)
    : env(the_env),
      settings(std::move(the_settings)),
      matcher(
          std::move(the_vocabulary),
          [this](const vocabulary::Vocabulary& by, const std::string& expression, ParticipantId from) {
            const bool is_own = from == ParticipantId{} || from == id;
            return expressions.place(by, expression, is_own ? std::nullopt : std::optional(from), env.now());
          },
          [this](const vocabulary::Vocabulary& by, vocabulary::ClassNumber offered, const SemanticIdentity& requested,
                 const matching::Classes& classes, ParticipantId from) {
            const bool is_own = from == ParticipantId{} || from == id;
            return overlaps.answer(by, offered, requested, classes, is_own ? std::nullopt : std::optional(from),
                                   env.now());
          }),
      neighbours(settings.group, membership::NeighbourTable::Affirmed::known),
      seal([this] { return env.random_bits(); }) {}

std::string Core::name() const { return settings.name.empty() ? to_string(id) : settings.name; }

std::uint64_t Core::digest() const { return vocabulary().digest(); }

Session* Core::find(PeerId peer) {
  const auto found = std::ranges::find(sessions, peer, [](const auto& entry) { return entry.second->peer(); });
  return found == sessions.end() || found->second->is_leaving ? nullptr : found->second.get();
}

std::vector<const Session*> Core::peers() const {
  std::vector<const Session*> peers;
  for (const auto& [stream, session] : sessions) {
    if (!session->is_leaving) peers.push_back(session.get());
  }
  std::ranges::sort(peers, {}, &Session::peer);
  return peers;
}

const env::Interface* Core::find(env::InterfaceIndex index) const {
  const auto& interfaces = env.interfaces();
  const auto found = std::ranges::find(interfaces, index, &env::Interface::index);
  return found == interfaces.end() ? nullptr : &*found;
}

bool Core::speaks_on(const env::Interface& interface) {
  if (!interface.twin_of) return true;
  const base::Instant now = env.now();
  return twins.is_needed(interface.index, now) || seal.asks_only_on(interface.index, *interface.twin_of, now);
}

std::size_t Core::peer_count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(sessions, [](const auto& entry) { return !entry.second->is_leaving; }));
}

std::size_t Core::service_count() const {
  std::size_t count = 0;
  for (const auto& [stream, session] : sessions) count += session->service_count();
  return count;
}

std::size_t Core::shared_count() const {
  std::size_t count = 0;
  for (const auto& [stream, session] : sessions) count += session->shared_count();
  return count;
}

std::size_t Core::promised_room() const {
  std::size_t room = 0;
  for (const auto& [stream, session] : sessions) room += session->room;
  return room;
}

void Core::refuse(Session& session, std::uint32_t statement, const Error& error) {
  ++counters.errors;
  if (error.code == ErrorCode::impossible) session.gate.charge(statements_per_impossible);
  session.say(statement, error);
}

Work Core::work() const {
  return worked + matcher.judged() * cost_of_judgement + counters.events * cost_of_event +
         matcher.filed() * cost_of_filing + expressions.counts().classified * cost_of_expression +
         overlaps.counts().decided * cost_of_overlap;
}

std::size_t Core::backlog(const Session& session) const {
  return env.unsent(session.stream()) + session.outbox_bytes();
}

}  // namespace geminga::participant
