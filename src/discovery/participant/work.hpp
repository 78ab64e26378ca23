// What things cost, so that a turn can be bounded by counted work and not by time, which tests could not repeat.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_WORK_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_WORK_HPP

#include <cstdint>

#include "base/time.hpp"

namespace geminga::participant {

/// Units of work; one is about a microsecond on a slow robot.
using Work = std::uint64_t;

inline constexpr Work cost_of_statement = 10;
/// An entry of the registry looked at.
inline constexpr Work cost_of_entry = 1;
/// A class that an entry is filed under when an ontology changes, or taken out of.
inline constexpr Work cost_of_filing = 1;
/// Whether a publication meets a subscription, its filter included.
inline constexpr Work cost_of_judgement = 2;
inline constexpr Work cost_of_answer_line = 10;
inline constexpr Work cost_of_event = 10;
/// A name that the ontology does not know: similar ones are looked for.
inline constexpr Work cost_of_unknown_name = 400;
/// A class expression that had to be classified.
inline constexpr Work cost_of_expression = 1000;
/// Whether two concepts can have instances in common.
inline constexpr Work cost_of_overlap = 500;

/// One event does about so much for clients; what is left is done in the next. Smaller: others are served sooner
/// meanwhile. Larger: less is spent on going round.
inline constexpr Work work_in_turn = 2000;
/// So much is done for one client before the next is looked for.
inline constexpr Work work_in_step = 200;
/// What a client has used counts for half after this time: who has used the least lately goes first.
inline constexpr base::Duration half_life = std::chrono::milliseconds(100);

}  // namespace geminga::participant

#endif
