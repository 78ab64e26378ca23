// Brings what is heard on the air into the registry.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_NEIGHBOUR_FEED_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_NEIGHBOUR_FEED_HPP

#include <cstddef>
#include <span>
#include <string_view>

#include "discovery/participant/announcer.hpp"
#include "discovery/participant/core.hpp"

namespace geminga::participant {

/// Takes in one datagram, whatever is in it. What follows for our own identifier is the result.
[[nodiscard]] Announcer::Consequence hear(Core& core, Announcer& announcer, env::InterfaceIndex interface,
                                          std::string_view source, std::span<const std::byte> datagram);
/// Brings what the neighbour table has changed into the registry: a little at once, the rest in turns, in its order.
void feed(Core& core);
/// Whether proceed_feed() has something to do.
[[nodiscard]] bool is_feed_due(const Core& core);
/// Goes on with what comes from neighbours, and with our own requests where they change their keys, until so much work
/// is done or nothing is left.
void proceed_feed(Core& core, Work most);
/// Removes what has not been heard of before its deadline.
void expire(Core& core, Announcer& announcer);

}  // namespace geminga::participant

#endif
