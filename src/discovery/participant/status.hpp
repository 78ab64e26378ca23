// `query status`: the participant itself, over all its rooms.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_STATUS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_STATUS_HPP

#include <string_view>
#include <vector>

#include "base/time.hpp"
#include "discovery/gcnp/statement.hpp"
#include "discovery/participant/air/air.hpp"
#include "discovery/participant/clients/answering.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/knowledge/knowledge.hpp"
#include "discovery/participant/settings.hpp"

namespace geminga::participant {

/// Facts that only the participant knows of itself.
struct Course {
  std::string_view phase;
  base::Duration uptime{};
  std::vector<gcnp::Parameter> of_owner;  ///< added by the daemon
};

[[nodiscard]] Answer answer_status(const Settings& settings, Course course, const Knowledge& knowledge, const Air& air,
                                   const Sessions& sessions, base::Instant now);

}  // namespace geminga::participant

#endif
