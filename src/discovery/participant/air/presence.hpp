// How a participant takes part in its team, and what it says there of itself.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_PRESENCE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_PRESENCE_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/participant/air/shared.hpp"
#include "discovery/sealing/seal.hpp"

namespace geminga::participant {

struct TeamSettings {
  /// The name that the team uses for this participant, e.g. the host's name: announcement::is_valid_name(). Empty: its
  /// identifier is its name.
  std::string name;
  /// The same number in all incarnations of this participant, so that the next one takes the place of the last at once;
  /// 0: no identity lasts.
  std::uint32_t lasting = 0;
  /// Only participants of the same group see each other.
  std::string group = "default";
  /// Time between two announcements of an unchanged state. Shorter: a lost participant is noticed sooner. Longer: fewer
  /// octets on the air. Within [announcement::min_interval, announcement::max_interval].
  base::Duration interval = std::chrono::seconds(2);
  /// Whether what is heard on one link is passed on to the others.
  bool relay = false;
  /// Whether other participants of the team are told, when they ask, what this one hears and how it is.
  bool diagnoses = false;
  /// The keys with which announcements are sealed at first, and how; Participant::set_sealing() changes it.
  sealing::Policy sealing;
  /// The things that it shares with other participants of its process; null: none.
  std::shared_ptr<Shared> shared;
};

/// The state that a participant announces. Asked for when a datagram is made, since of many changes between two
/// datagrams only the last counts.
struct OwnState {
  std::function<std::uint64_t()> ontology_digest;
  /// Its peers that offer or ask for anything, in ascending order.
  std::function<std::vector<announcement::PeerState>()> peers;
  /// The answer to an inquiry of this participant.
  std::function<std::vector<std::string>(ParticipantId asker)> diagnosis;
};

}  // namespace geminga::participant

#endif
