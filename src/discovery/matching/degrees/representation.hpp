// The degree of representations, and the degree of an identity as a whole.
#ifndef GEMINGA_DISCOVERY_MATCHING_DEGREES_REPRESENTATION_HPP
#define GEMINGA_DISCOVERY_MATCHING_DEGREES_REPRESENTATION_HPP

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "discovery/matching/degrees/degree.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// The degree of an offered and a requested representation. A request without a representation accepts any, also an
/// unstated one, exactly. An offer without a representation meets no request that states one, because the consumer
/// could not read it. Between two stated ones the ontology decides as between concepts. Where the offered one is
/// neither exact nor equivalent nor narrower, it is converted if a chain costs no more than `convert`.
[[nodiscard]] std::optional<Match> degree_of_representation(const NamedClass& offered, const NamedClass& requested,
                                                            const vocabulary::Vocabulary& vocabulary,
                                                            std::uint32_t convert = 0, const AskChain& chains = {});

/// The cheapest chain between two representations, from `chains`, or of declared conversions where that is empty; null
/// where there is none, or one of them is not known. It is given even where no conversion is needed.
[[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain_between(std::optional<taxonomy::ClassNumber> offered,
                                                                     std::optional<taxonomy::ClassNumber> requested,
                                                                     const vocabulary::Vocabulary& vocabulary,
                                                                     const AskChain& chains = {});
/// The classes of a chain in short names: "A>B>C". Empty for null.
[[nodiscard]] std::string chain_words(const vocabulary::Chain* chain, const vocabulary::Vocabulary& vocabulary);

/// The weaker of two degrees, with the sum of the distances. At most one of the two is converted: the result has its
/// cost and chain.
[[nodiscard]] Match combined(const Match& one, const Match& other);

}  // namespace geminga::matching

#endif
