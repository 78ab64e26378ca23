// How an offer that meets a request stands among all that do, in words.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_ARBITRATION_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_ARBITRATION_HPP

#include <cstddef>

#include "discovery/participant/queries/sides.hpp"
#include "discovery/participant/queries/survey.hpp"

namespace geminga::participant {

/// Of a pair that meets, after a survey for the request by the rank of the offer, whether somebody has stated them or
/// not.
[[nodiscard]] Check check_arbitration(matching::Matcher& matcher, const Survey& survey, const Offered& offer,
                                      const matching::Rank& rank);
/// Where an offer stands of which others take the places.
struct Outranking {
  std::size_t place = 0;    ///< among all that meet the request, from 1
  std::size_t settled = 0;  ///< where those that are chosen keep their places against it
  std::size_t candidates = 0;
};

/// Where the request is given others: `rival` is the last that is chosen.
[[nodiscard]] Check outranked(const matching::Matcher& matcher, const Asked& asked,
                              const registry::PublicationEntry& offer, const Outranking& among,
                              const registry::PublicationEntry* rival);

}  // namespace geminga::participant

#endif
