// The settings of a participant, given once at its start.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_SETTINGS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_SETTINGS_HPP

#include <memory>
#include <string>

#include "discovery/matching/matcher.hpp"
#include "discovery/participant/air/presence.hpp"
#include "discovery/participant/clients/limits.hpp"

namespace geminga::participant {

struct Settings : TeamSettings {
  /// Names the program in `query status`, e.g. "1.0.0".
  std::string version = "0";
  /// A class expression that describes the participant; empty: it is not described. Participant::describe() changes it.
  std::string description;
  ClientLimits limits;
  /// The entries of the registry that it shares with other participants of its process; null: none.
  std::shared_ptr<registry::SharedEntries> shared_entries;
};

}  // namespace geminga::participant

#endif
