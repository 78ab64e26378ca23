// What a peer is told of the changes that concern its requests: at once, or when its turn comes.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_TELLING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_TELLING_HPP

#include <cstdint>

#include "discovery/participant/core.hpp"

namespace geminga::participant {

/// Hands what the matcher has to tell to the peers, in its order. Per request and service each peer is told add
/// (modify)* del, whatever was left out because it lagged. O(events).
void deliver_events(Core& core);
/// Tells a peer that everything is gone that it was told of for this request, which it keeps.
void tell_gone(Core& core, Session& session, std::uint32_t number, matching::Reason reason);
/// Whether proceed_picture() has something to do.
[[nodiscard]] bool has_picture(const Session& session);
/// Tells the next piece of how things stand, of the request with the smallest number for which that is due.
void proceed_picture(Core& core, Session& session);

}  // namespace geminga::participant

#endif
