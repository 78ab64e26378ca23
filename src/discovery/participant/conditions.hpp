// Conditions and wishes of what a peer states, by the units that are known.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CONDITIONS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CONDITIONS_HPP

#include "discovery/participant/core.hpp"
#include "discovery/participant/statements.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// Why `for`, or `where`, `prefer`, `favour` and `rank`, cannot be read. 503 where that may be because of a unit that
/// the first ontology, which is still being read, may declare: then the statement waits for it as one with a concept
/// does.
[[nodiscard]] Refusal check_conditions(const Core& core, const Publication& publication);
[[nodiscard]] Refusal check_conditions(const Core& core, const Subscription& subscription);

[[nodiscard]] inline bool is_awaited(const Refusal& refusal) {
  return refusal && refusal->code == ErrorCode::not_ready;
}

}  // namespace geminga::participant

#endif
