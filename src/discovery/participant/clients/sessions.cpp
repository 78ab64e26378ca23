#include "discovery/participant/clients/sessions.hpp"

#include <algorithm>

namespace geminga::participant {
namespace {

/// A name that was looked for in vain was compared with many.
constexpr std::size_t statements_per_impossible = 40;

template <typename Size>
std::size_t sum(const Sessions::Map& sessions, Size size) {
  std::size_t count = 0;
  for (const auto& [stream, session] : sessions) count += size(*session);
  return count;
}

}  // namespace

Session* Sessions::find(env::StreamId stream) {
  const auto found = all.find(stream);
  return found == all.end() || found->second->is_leaving ? nullptr : found->second.get();
}

Session* Sessions::find(PeerId peer) {
  const auto found = std::ranges::find(all, peer, [](const auto& entry) { return entry.second->peer(); });
  return found == all.end() || found->second->is_leaving ? nullptr : found->second.get();
}

std::vector<const Session*> Sessions::peers() const {
  std::vector<const Session*> peers;
  for (const auto& [stream, session] : all) {
    if (!session->is_leaving) peers.push_back(session.get());
  }
  std::ranges::sort(peers, {}, &Session::peer);
  return peers;
}

std::size_t Sessions::peer_count() const {
  return sum(all, [](const Session& one) -> std::size_t { return one.is_leaving ? 0 : 1; });
}

std::size_t Sessions::publication_count() const {
  return sum(all, [](const Session& one) { return one.services.publications.size(); });
}

std::size_t Sessions::subscription_count() const {
  return sum(all, [](const Session& one) { return one.services.subscriptions.size(); });
}

std::size_t Sessions::shared_count() const {
  return sum(all, [](const Session& one) { return one.services.shared_count(); });
}

std::size_t Sessions::promised_room() const {
  return sum(all, [](const Session& one) { return one.services.room; });
}

void Sessions::refuse(Session& session, std::uint32_t id, const Error& error) {
  ++counters.errors;
  if (error.code == ErrorCode::impossible) session.gate.charge(statements_per_impossible);
  session.say(id, error);
}

}  // namespace geminga::participant
