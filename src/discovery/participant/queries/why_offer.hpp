// `query why` of an offer alone.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_WHY_OFFER_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_WHY_OFFER_HPP

#include "discovery/participant/queries/answering.hpp"
#include "discovery/participant/queries/sides.hpp"

namespace geminga::participant {

/// Who takes it, who has better ones, and who comes near; where nobody takes it, why.
[[nodiscard]] Answering explaining(Offered offer);

}  // namespace geminga::participant

#endif
