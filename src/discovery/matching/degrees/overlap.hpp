// The degree of concepts that overlap: neither subsumes the other, and something can be both (OVERLAPPING.md).
#ifndef GEMINGA_DISCOVERY_MATCHING_DEGREES_OVERLAP_HPP
#define GEMINGA_DISCOVERY_MATCHING_DEGREES_OVERLAP_HPP

#include <functional>
#include <memory>

#include "discovery/matching/degrees/degree.hpp"
#include "geminga/identity.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// The answer to whether two concepts overlap; null: that waits to be decided.
using OverlapAnswer = std::shared_ptr<const vocabulary::Overlap>;

/// Answers whether an offered concept overlaps with what is asked for: each is a satisfiable class, or an expression
/// that has a place. `from` is the participant that asks.
using Overlapping = std::function<OverlapAnswer(const vocabulary::Vocabulary& vocabulary, const Meaning& offered,
                                                const Meaning& requested, ParticipantId from)>;

/// Lets the reasoner decide at once, and remembers nothing. An expression must be one that the vocabulary can read.
[[nodiscard]] OverlapAnswer decided_at_once(const vocabulary::Vocabulary& vocabulary, const Meaning& offered,
                                            const Meaning& requested);

/// The degree of concepts that have none by subsumption; nothing where it is not certain that something can be both.
[[nodiscard]] std::optional<Match> degree_of_overlap(const Meaning& offered, const Classes& requested,
                                                     const vocabulary::Vocabulary& vocabulary,
                                                     const AskOverlap& overlaps);
/// The answer about two concepts; null also where one of them has no meaning here.
[[nodiscard]] OverlapAnswer answer_of_overlap(const Meaning& offered, const Classes& requested,
                                              const vocabulary::Vocabulary& vocabulary, const AskOverlap& overlaps);

}  // namespace geminga::matching

#endif
