// The arbitration of an offer that meets a request, among all that do, in words.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_ARBITRATION_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_ARBITRATION_HPP

#include <cstddef>

#include "discovery/participant/queries/sides.hpp"
#include "discovery/participant/queries/survey.hpp"

namespace geminga::participant {

/// Checks a pair that meets, either of which may be stated by nobody. `survey` is one for the request by the rank of
/// the offer, and over.
[[nodiscard]] Check check_arbitration(matching::Matcher& matcher, const Survey& survey, const Offered& offer,
                                      const matching::Rank& rank);
/// The places of an offer that is not chosen.
struct Outranking {
  std::size_t place = 0;    ///< among all that meet the request, from 1
  std::size_t settled = 0;  ///< its place where the chosen ones keep theirs against it
  std::size_t candidates = 0;
};

/// The check of an offer that is not chosen; `rival` is the last that is.
[[nodiscard]] Check outranked(const matching::Matcher& matcher, const Asked& asked,
                              const registry::PublicationEntry& offer, const Outranking& among,
                              const registry::PublicationEntry* rival);

}  // namespace geminga::participant

#endif
