// Limits of what a bridge states to the daemon for others.
#ifndef GEMINGA_BRIDGE_TEAM_LIMITS_HPP
#define GEMINGA_BRIDGE_TEAM_LIMITS_HPP

#include <chrono>
#include <cstddef>

namespace geminga::bridge {

/// Publications that are stated at a time, and as many subscriptions. A peer of the daemon may have 256 of each
/// (src/discovery/participant/clients/limits.hpp). More wait until one goes.
inline constexpr std::size_t max_stated = 240;
/// Publications and subscriptions that wait for their place. One more is left out and counted.
inline constexpr std::size_t max_waiting = 4096;
/// Questions that wait for an answer of the daemon. One more is answered by nothing.
inline constexpr std::size_t max_questions = 16;
/// The time within which the daemon has to answer a question. A daemon that does not is left.
inline constexpr std::chrono::seconds answer_patience{10};
/// The time between two looks at whether the daemon's ontology has changed. Shorter: services have their concepts
/// earlier after a reload. Longer: fewer questions.
inline constexpr std::chrono::seconds ontology_look{5};
/// The least time between two lines that tell the same kind of count.
inline constexpr std::chrono::seconds tally_pause{5};

}  // namespace geminga::bridge

#endif
