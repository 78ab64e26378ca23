// The way to a participant that is heard through relays, as lines tell it.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_WAYS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_WAYS_HPP

#include "discovery/gcnp/way.hpp"
#include "discovery/membership/neighbours.hpp"
#include "discovery/participant/clients/answering.hpp"

namespace geminga::participant {

/// The names of the relays on the way, or identifiers where a name is not known. No hops: it is heard directly, or is
/// unknown, as we ourselves are.
[[nodiscard]] gcnp::Way way_of(ParticipantId participant, const membership::Neighbours& neighbours);
/// Appends `hops path reachable` of the way to a participant.
void append_way(Line& line, ParticipantId participant, const membership::Neighbours& neighbours);
/// The same of the way to a service or consumer of it, whose address may be another one.
template <typename Entry>
void append_way(Line& line, const Entry& entry, const membership::Neighbours& neighbours) {
  gcnp::Way way = way_of(entry.key.participant, neighbours);
  way.is_reachable = entry.is_reachable;
  gcnp::append_way(line, way);
}
/// The address from which its words come where it announces others alone (membership::observed_address()).
[[nodiscard]] std::string observed_address(ParticipantId participant, const membership::Neighbours& neighbours);

}  // namespace geminga::participant

#endif
