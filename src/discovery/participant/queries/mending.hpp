// What a consumer or a provider may do so that a request takes what is offered.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_MENDING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_MENDING_HPP

#include <optional>
#include <string>
#include <string_view>

#include "discovery/participant/queries/checks.hpp"

namespace geminga::participant {

/// What mends that an expression has no name: nothing is missing of one that has.
inline constexpr std::string_view mend_of_gaps =
    "define a class as equivalent to the expression in the ontology, then everything is found; the request may stay";

/// What would mend an identity that does not fit. `match` is that of the pair where it is too weak, `chain` what would
/// turn its representation into what is asked for, or null.
[[nodiscard]] std::string mend_of_identity(const matching::Matcher& matcher, const Asked& asked,
                                           const registry::PublicationEntry& offered, matching::Obstacle obstacle,
                                           const std::optional<matching::Match>& match, const vocabulary::Chain* chain);

/// Of a check that is not well: what its `mend` says to the consumer, said to the provider first.
[[nodiscard]] std::string mend_by_provider(const matching::Matcher& matcher, const Asked& asked,
                                           const registry::PublicationEntry& offer, const Check& check);

}  // namespace geminga::participant

#endif
