// Which representations suit a consumer, and how they change the degree of the whole identity.
#ifndef GEMINGA_DISCOVERY_MATCHING_REPRESENTATION_HPP
#define GEMINGA_DISCOVERY_MATCHING_REPRESENTATION_HPP

#include <optional>
#include <string>

#include "discovery/matching/degree.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// A request without a representation takes any, also an unstated one, and that weakens nothing: nothing was asked for
/// that is not met. A request with one is never met by an offer that states none, because the consumer could not read
/// it. Between two stated ones the ontology decides as it does between concepts.
[[nodiscard]] std::optional<Match> degree_of_representation(const std::string& offered_iri,
                                                            std::optional<taxonomy::ClassNumber> offered,
                                                            const std::string& requested_iri,
                                                            std::optional<taxonomy::ClassNumber> requested,
                                                            const vocabulary::Vocabulary& vocabulary);

/// The weaker of the two degrees, and the distances added.
[[nodiscard]] Match combined(const Match& by_concept, const Match& by_representation);

}  // namespace geminga::matching

#endif
