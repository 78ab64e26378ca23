// Mending: what a consumer or a provider may do so that a request takes an offer.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_MENDING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_MENDING_HPP

#include <optional>
#include <string>
#include <string_view>

#include "discovery/participant/queries/checks.hpp"

namespace geminga::participant {

/// Advice for an expression of which something may be missed: of one that a class is defined by, everything is found.
inline constexpr std::string_view mend_of_gaps =
    "define a class as equivalent to the expression in the ontology, then everything is found; the request may stay";

/// Advice for hosts whose ontologies differ.
inline constexpr std::string_view mend_of_ontologies =
    "load the same ontologies on every host; geminga-query ontology lists the hosts that have others";

/// Advice for an identity that does not fit. `match` is the match of the pair where it is too weak; `chain` converts
/// its representation into the one that is asked for, or is null.
[[nodiscard]] std::string mend_of_identity(const matching::Examination& examination, const Asked& asked,
                                           const registry::PublicationEntry& offered, matching::Obstacle obstacle,
                                           const std::optional<matching::Match>& match, const vocabulary::Chain* chain);

/// The advice of a failed check, said to the provider first: its `mend` is said to the consumer first.
[[nodiscard]] std::string mend_by_provider(const matching::Examination& examination, const Asked& asked,
                                           const registry::PublicationEntry& offer, const Check& check);

}  // namespace geminga::participant

#endif
