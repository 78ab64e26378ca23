// Concepts that overlap: neither is above the other, and something can be both. The reasoner decides that
// (OVERLAPPING.md).
#ifndef GEMINGA_DISCOVERY_MATCHING_OVERLAP_HPP
#define GEMINGA_DISCOVERY_MATCHING_OVERLAP_HPP

#include <functional>
#include <memory>

#include "discovery/matching/degree.hpp"
#include "geminga/identity.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// Null: it waits to be decided.
using OverlapAnswer = std::shared_ptr<const vocabulary::Overlap>;

/// Answers for a satisfiable class that is offered, and what is asked for: a satisfiable class, or an expression that
/// has a place. `from` says who asks: its own participant, or one on the air.
using Overlapping = std::function<OverlapAnswer(const vocabulary::Vocabulary& vocabulary,
                                                vocabulary::ClassNumber offered, const SemanticIdentity& requested,
                                                const Classes& requested_classes, ParticipantId from)>;

/// Decides at once, and remembers nothing. An expression must be one that the vocabulary can read.
[[nodiscard]] OverlapAnswer decided_at_once(const vocabulary::Vocabulary& vocabulary, vocabulary::ClassNumber offered,
                                            const SemanticIdentity& requested, const Classes& requested_classes);

/// The degree of concepts that have none by subsumption; nothing unless it is certain that something can be both.
[[nodiscard]] std::optional<Match> degree_of_overlap(const Classes& offered, const Classes& requested,
                                                     const vocabulary::Vocabulary& vocabulary,
                                                     const AskOverlap& overlaps);
/// What is known of them; null also where one of them has no class.
[[nodiscard]] OverlapAnswer answer_of_overlap(const Classes& offered, const Classes& requested,
                                              const vocabulary::Vocabulary& vocabulary, const AskOverlap& overlaps);

}  // namespace geminga::matching

#endif
