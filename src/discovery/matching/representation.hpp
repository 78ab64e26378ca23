// Which representations suit a consumer, and how they change the degree of the whole identity.
#ifndef GEMINGA_DISCOVERY_MATCHING_REPRESENTATION_HPP
#define GEMINGA_DISCOVERY_MATCHING_REPRESENTATION_HPP

#include <cstdint>
#include <optional>
#include <string>

#include "discovery/matching/degree.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// A request without a representation takes any, also an unstated one, and that weakens nothing: nothing was asked for
/// that is not met. A request with one is never met by an offer that states none, because the consumer could not read
/// it. Between two stated ones the ontology decides as it does between concepts. Where the offered one is neither the
/// same nor narrower it is converted, if a declared chain costs no more than `convert`.
[[nodiscard]] std::optional<Match> degree_of_representation(const std::string& offered_iri,
                                                            std::optional<taxonomy::ClassNumber> offered,
                                                            const std::string& requested_iri,
                                                            std::optional<taxonomy::ClassNumber> requested,
                                                            const vocabulary::Vocabulary& vocabulary,
                                                            std::uint32_t convert = 0);

/// The chain by which an offered identity is turned into a requested one: "A>B>C" in short names. Empty where there is
/// none, whether one is needed or not.
[[nodiscard]] std::string chain_words(const Identity& offered, const Identity& requested,
                                      const vocabulary::Vocabulary& vocabulary);

/// The weaker of the two degrees, and the distances added. One of them at most is converted: its cost and chain stay.
[[nodiscard]] Match combined(const Match& one, const Match& other);

}  // namespace geminga::matching

#endif
