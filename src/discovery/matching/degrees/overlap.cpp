#include "discovery/matching/degrees/overlap.hpp"

#include "reasoning/vocabulary/expression.hpp"

namespace geminga::matching {

using vocabulary::Overlap;

OverlapAnswer decided_at_once(const vocabulary::Vocabulary& vocabulary, const Meaning& offered,
                              const Meaning& requested) {
  const auto answer = [](Overlap overlap) { return std::make_shared<const Overlap>(std::move(overlap)); };
  if (!offered.classes.place && !requested.classes.place) {
    return answer(vocabulary.overlap(offered.classes.concept_class.value(), requested.classes.concept_class.value()));
  }
  if (const auto ready = vocabulary.check_expressions(); !ready) return answer({.reason = ready.error().text});
  const auto read = [&](const Meaning& one) {
    return vocabulary.read(one.identity.concept_iri, vocabulary::max_expression_bytes);
  };
  // Overlapping is symmetric, so that a class may be either side.
  const bool is_offered = offered.classes.place != nullptr;
  const auto one = read(is_offered ? offered : requested);
  if (!one) return answer({.reason = one.error().text});
  const vocabulary::Place& place = is_offered ? *offered.classes.place : *requested.classes.place;
  const auto named = is_offered ? requested.classes.concept_class : offered.classes.concept_class;
  if (named) return answer(vocabulary.overlap(*named, *one, place));
  const auto other = read(requested);
  if (!other) return answer({.reason = other.error().text});
  return answer(vocabulary.overlap(*one, place, *other, *requested.classes.place));
}

OverlapAnswer answer_of_overlap(const Meaning& offered, const Classes& requested,
                                const vocabulary::Vocabulary& vocabulary, const AskOverlap& overlaps) {
  const bool has_classes = has_meaning(offered.classes) && has_meaning(requested);
  return overlaps && has_classes ? overlaps(vocabulary, offered) : nullptr;
}

std::optional<Match> degree_of_overlap(const Meaning& offered, const Classes& requested,
                                       const vocabulary::Vocabulary& vocabulary, const AskOverlap& overlaps) {
  const OverlapAnswer answer = answer_of_overlap(offered, requested, vocabulary, overlaps);
  if (answer == nullptr || answer->verdict != Overlap::Verdict::possible) return std::nullopt;
  return Match{Degree::overlapping, answer->distance};
}

}  // namespace geminga::matching
