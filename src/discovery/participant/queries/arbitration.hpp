// How an offer that meets a request stands among all that do, in words.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_ARBITRATION_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_ARBITRATION_HPP

#include <cstddef>

#include "discovery/matching/standing.hpp"
#include "discovery/participant/queries/survey.hpp"

namespace geminga::participant {

/// Of a pair that is known to the matcher.
[[nodiscard]] Check check_arbitration(const Core& core, const Asked& asked, const registry::PublicationEntry& offer,
                                      const matching::Standing& standing);
/// Of one of which at least one side is stated by nobody, after a survey by the rank of the offer.
[[nodiscard]] Check check_arbitration(const Core& core, const Survey& survey, const registry::PublicationEntry& offer,
                                      const matching::Rank& rank, bool is_offer_living);
/// Where the request is given others: `place` counts from 1, `rival` is the last that is chosen.
[[nodiscard]] Check outranked(const Core& core, const Asked& asked, const registry::PublicationEntry& offer,
                              std::size_t place, std::size_t candidates, const registry::PublicationEntry* rival);

}  // namespace geminga::participant

#endif
