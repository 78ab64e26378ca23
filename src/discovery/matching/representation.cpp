// Representations: the consumer's side decides.
#include "discovery/matching/representation.hpp"

#include <algorithm>
#include <limits>

namespace geminga::matching {

std::optional<Match> degree_of_representation(const std::string& offered_iri,
                                              std::optional<taxonomy::ClassNumber> offered,
                                              const std::string& requested_iri,
                                              std::optional<taxonomy::ClassNumber> requested,
                                              const vocabulary::Vocabulary& vocabulary) {
  if (requested_iri.empty()) return Match{Degree::exact, 0};
  if (offered_iri.empty()) return std::nullopt;
  return degree_of_name(offered_iri, offered, requested_iri, requested, vocabulary);
}

Match combined(const Match& by_concept, const Match& by_representation) {
  constexpr auto farthest = std::numeric_limits<std::uint32_t>::max();
  const bool fits = by_concept.distance <= farthest - by_representation.distance;
  return {std::max(by_concept.degree, by_representation.degree),
          fits ? by_concept.distance + by_representation.distance : farthest};
}

}  // namespace geminga::matching
