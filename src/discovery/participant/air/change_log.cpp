#include "discovery/participant/air/change_log.hpp"

#include <algorithm>
#include <map>
#include <variant>
#include <vector>

namespace geminga::participant {
namespace {

using announcement::NumberedPublication;
using announcement::NumberedSubscription;
using announcement::PeerState;

/// One service, and the name of its peer.
struct Entry {
  const PeerState* peer = nullptr;
  std::variant<const NumberedPublication*, const NumberedSubscription*> service;

  friend bool operator==(const Entry& a, const Entry& b) {
    const auto is_same = [](const auto* one, const auto* other) {
      if constexpr (std::is_same_v<decltype(one), decltype(other)>) return *one == *other;
      return false;
    };
    return a.peer->name == b.peer->name && std::visit(is_same, a.service, b.service);
  }
};
using Entries = std::map<std::pair<PeerId, std::uint32_t>, Entry>;

Entries entries_of(const announcement::Announcement& state) {
  Entries entries;
  for (const PeerState& peer : state.peers) {
    for (const auto& entry : peer.publications) entries[{peer.id, entry.number}] = {&peer, &entry};
    for (const auto& entry : peer.subscriptions) entries[{peer.id, entry.number}] = {&peer, &entry};
  }
  return entries;
}

}  // namespace

void ChangeLog::update(announcement::Announcement state, base::Instant now) {
  const bool is_same_participant = state.participant == state_.participant && state.name == state_.name &&
                                   state.ontology_digest == state_.ontology_digest;
  if (std::exchange(is_new_, false) || !is_same_participant) {
    changed_.clear();
    revisions_.clear();
  } else {
    const auto before = entries_of(state_);
    const auto after = entries_of(state);
    for (const auto& [service, entry] : before) {
      const auto still = after.find(service);
      if (still == after.end() || !(still->second == entry)) changed_[service] = state.revision;
    }
    for (const auto& [service, entry] : after) {
      if (!before.contains(service)) changed_[service] = state.revision;
    }
  }
  revisions_.push_back({now, state.revision});
  while (revisions_.size() > 1 && now - revisions_[1].said >= change_settles_after) revisions_.pop_front();
  std::erase_if(changed_, [this](const auto& entry) { return entry.second <= revisions_.front().number; });
  state_ = std::move(state);
}

std::optional<announcement::Announcement> ChangeLog::change() const {
  if (changed_.empty()) return std::nullopt;
  auto change = state_;
  change.kind = announcement::Kind::change;
  change.since = revisions_.front().number;
  auto gone = changed_;
  for (PeerState& peer : change.peers) {
    const auto is_as_it_was = [&](const auto& numbered) { return gone.erase({peer.id, numbered.number}) == 0; };
    std::erase_if(peer.publications, is_as_it_was);
    std::erase_if(peer.subscriptions, is_as_it_was);
  }
  for (const auto& [service, revision] : gone) {
    auto peer = std::ranges::lower_bound(change.peers, service.first, {}, &PeerState::id);
    if (peer == change.peers.end() || peer->id != service.first) {
      peer = change.peers.insert(peer, PeerState{service.first, {}, {}, {}, {}, {}});
    }
    peer->removed.push_back(service.second);
  }
  std::erase_if(change.peers, [](const PeerState& peer) {
    return peer.publications.empty() && peer.subscriptions.empty() && peer.removed.empty();
  });
  return change;
}

}  // namespace geminga::participant
