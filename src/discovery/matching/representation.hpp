// Which representations suit a consumer, and how they change the degree of the whole identity.
#ifndef GEMINGA_DISCOVERY_MATCHING_REPRESENTATION_HPP
#define GEMINGA_DISCOVERY_MATCHING_REPRESENTATION_HPP

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "discovery/matching/degree.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// A request without a representation takes any, also an unstated one, and that weakens nothing: nothing was asked for
/// that is not met. A request with one is never met by an offer that states none, because the consumer could not read
/// it. Between two stated ones the ontology decides as it does between concepts. Where the offered one is neither the
/// same nor narrower it is converted, if a chain costs no more than `convert`.
[[nodiscard]] std::optional<Match> degree_of_representation(const std::string& offered_iri,
                                                            std::optional<taxonomy::ClassNumber> offered,
                                                            const std::string& requested_iri,
                                                            std::optional<taxonomy::ClassNumber> requested,
                                                            const vocabulary::Vocabulary& vocabulary,
                                                            std::uint32_t convert = 0, const AskChain& chains = {});

/// The cheapest chain between two representations, as `chains` says, or of declared conversions where that is empty;
/// null where there is none, or one of them is not known. Whether one is needed does not matter.
[[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain_between(std::optional<taxonomy::ClassNumber> offered,
                                                                     std::optional<taxonomy::ClassNumber> requested,
                                                                     const vocabulary::Vocabulary& vocabulary,
                                                                     const AskChain& chains = {});
/// "A>B>C" in short names. Empty for null.
[[nodiscard]] std::string chain_words(const vocabulary::Chain* chain, const vocabulary::Vocabulary& vocabulary);

/// The weaker of the two degrees, and the distances added. One of them at most is converted: its cost and chain stay.
[[nodiscard]] Match combined(const Match& one, const Match& other);

}  // namespace geminga::matching

#endif
