// Whose statement, answer or picture is next: clients take turns, and no event does more than a bounded part of it all.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_TURNS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_TURNS_HPP

#include "discovery/participant/core.hpp"

namespace geminga::participant {

/// Whether something of the client waits to be handled: lines, the rest of an answer, what it is to be told.
[[nodiscard]] bool has_business(Session& session);
/// Whether some of that can be done now: it does not wait for an ontology, and there is room for what the client is
/// told.
[[nodiscard]] bool has_work(Core& core, Session& session);
/// The same of anybody: then another turn is due at once.
[[nodiscard]] bool is_turn_due(Core& core);
/// Does work for clients until work_in_turn is done or nobody has any. Of those that have, the one that used the least
/// lately is served, then the next. Requires an identifier.
///
/// What is not divided: one statement. It judges each service that it is about against each subscription that it may
/// meet, and gives each local peer at most one event for each of its requests that the service concerns: at most as
/// many as Limits::services in all.
void take_turn(Core& core);

}  // namespace geminga::participant

#endif
