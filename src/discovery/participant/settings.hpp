// The settings of a participant, given once at its start.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_SETTINGS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_SETTINGS_HPP

#include <string>

#include "discovery/participant/air/presence.hpp"
#include "discovery/participant/clients/limits.hpp"

namespace geminga::participant {

struct Settings : TeamSettings {
  /// Names the program in `query status`, e.g. "1.0.0".
  std::string version = "0";
  ClientLimits limits;
};

}  // namespace geminga::participant

#endif
