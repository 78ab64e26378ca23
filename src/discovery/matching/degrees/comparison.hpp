// The degree of two class expressions, one offered and one asked for.
#ifndef GEMINGA_DISCOVERY_MATCHING_DEGREES_COMPARISON_HPP
#define GEMINGA_DISCOVERY_MATCHING_DEGREES_COMPARISON_HPP

#include <functional>
#include <memory>
#include <optional>

#include "discovery/matching/degrees/degree.hpp"
#include "geminga/identity.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// The answer to how an offered expression relates to a requested one; null: that waits to be decided.
using ComparisonAnswer = std::shared_ptr<const vocabulary::Comparison>;

/// Answers how an offered expression, the first, relates to a requested one. Both have places. `from` is the
/// participant that asks.
using Comparing = std::function<ComparisonAnswer(const vocabulary::Vocabulary& vocabulary, const Meaning& offered,
                                                 const Meaning& requested, ParticipantId from)>;

/// Lets the reasoner decide at once, and remembers nothing.
[[nodiscard]] ComparisonAnswer compared_at_once(const vocabulary::Vocabulary& vocabulary, const Meaning& offered,
                                                const Meaning& requested);

/// The degree of the offered expression, which is the first of the comparison; nothing where they are apart.
[[nodiscard]] std::optional<Match> degree_of_comparison(const vocabulary::Comparison& comparison);

}  // namespace geminga::matching

#endif
