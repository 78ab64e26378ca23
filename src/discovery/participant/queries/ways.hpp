// The way to a participant that is heard through relays, as lines tell it.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_WAYS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_WAYS_HPP

#include "discovery/gcnp/way.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/participant/clients/answering.hpp"

namespace geminga::participant {

/// The names of the relays on the way, or identifiers where a name is not known. No hops: it is heard directly, or is
/// unknown, as we ourselves are.
[[nodiscard]] gcnp::Way way_of(ParticipantId participant, const membership::NeighbourTable& neighbours);
/// Appends `hops path` of the way to a participant.
void append_way(Line& line, ParticipantId participant, const membership::NeighbourTable& neighbours);
/// The address from which its words come where it announces another one on each of its ways; empty: there is none. A
/// translation of addresses lies between, or it announces what it was told to (announce-address).
[[nodiscard]] std::string observed_address(ParticipantId participant, const membership::NeighbourTable& neighbours);

}  // namespace geminga::participant

#endif
