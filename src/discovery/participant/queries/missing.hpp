// Near misses of an offer: what is not known of it that a request asks for, and what contradicts (QUERIES.md, "Near
// misses").
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_MISSING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_MISSING_HPP

#include <cstddef>
#include <optional>

#include "discovery/participant/clients/answering.hpp"
#include "geminga/identity.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

/// Questions to the reasoner about one pair.
inline constexpr std::size_t max_missing_questions = 64;
/// Different offered concepts that one `match missing=1` compares with what is asked for.
inline constexpr std::size_t max_missing_concepts = 32;
/// Services that it tells of, unless the query states a limit.
inline constexpr std::size_t max_told_missing = 8;
/// Octets of one list of conjuncts; the rest is left out.
inline constexpr std::size_t max_missing_bytes = 4096;

/// The ways to make an offered concept match a requested one. Nothing where one of them is none, cannot be read here,
/// or where the vocabulary cannot read expressions (yet).
[[nodiscard]] std::optional<vocabulary::NearMisses> missing_between(const vocabulary::Vocabulary& vocabulary,
                                                                    const Identity& requested, const Identity& offered);

/// Appends `missing_count missing contradicting_count contradicting` of the smallest way, `ways` for the others, and
/// `reservation`; nothing where there is no way.
void append_missing(Line& line, const vocabulary::NearMisses& near_misses);

}  // namespace geminga::participant

#endif
