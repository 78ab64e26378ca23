// `query why` of an offer alone.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_WHY_OFFER_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_WHY_OFFER_HPP

#include "discovery/matching/matcher.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/participant/clients/answering.hpp"
#include "discovery/participant/knowledge/overlaps.hpp"
#include "discovery/participant/queries/sides.hpp"

namespace geminga::participant {

/// Who takes it, who has better ones, and who comes near; where nobody takes it, why.
[[nodiscard]] Answering explaining(matching::Matcher& matcher, const Overlaps& overlaps,
                                   const membership::NeighbourTable& neighbours, Offered offer);

}  // namespace geminga::participant

#endif
