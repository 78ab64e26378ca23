#include "discovery/matching/degrees/overlap.hpp"

#include "reasoning/vocabulary/expression.hpp"

namespace geminga::matching {

using vocabulary::Overlap;

OverlapAnswer decided_at_once(const vocabulary::Vocabulary& vocabulary, const SemanticIdentity& offered,
                              const Classes& offered_classes, const SemanticIdentity& requested,
                              const Classes& requested_classes) {
  const auto answer = [](Overlap overlap) { return std::make_shared<const Overlap>(std::move(overlap)); };
  if (!offered_classes.place && !requested_classes.place) {
    return answer(vocabulary.overlap(offered_classes.concept_class.value(), requested_classes.concept_class.value()));
  }
  if (const auto ready = vocabulary.check_expressions(); !ready) return answer({.reason = ready.error().text});
  const auto read = [&](const SemanticIdentity& one) {
    return vocabulary.read(one.concept_iri, vocabulary::max_expression_bytes);
  };
  // Overlapping is symmetric, so that a class may be either side.
  const bool is_offered = offered_classes.place != nullptr;
  const auto one = read(is_offered ? offered : requested);
  if (!one) return answer({.reason = one.error().text});
  const vocabulary::Place& place = is_offered ? *offered_classes.place : *requested_classes.place;
  const auto named = is_offered ? requested_classes.concept_class : offered_classes.concept_class;
  if (named) return answer(vocabulary.overlap(*named, *one, place));
  const auto other = read(requested);
  if (!other) return answer({.reason = other.error().text});
  return answer(vocabulary.overlap(*one, place, *other, *requested_classes.place));
}

OverlapAnswer answer_of_overlap(const SemanticIdentity& offer, const Classes& offered, const Classes& requested,
                                const vocabulary::Vocabulary& vocabulary, const AskOverlap& overlaps) {
  const bool has_classes = has_meaning(offered) && has_meaning(requested);
  return overlaps && has_classes ? overlaps(vocabulary, offer, offered) : nullptr;
}

std::optional<Match> degree_of_overlap(const SemanticIdentity& offer, const Classes& offered, const Classes& requested,
                                       const vocabulary::Vocabulary& vocabulary, const AskOverlap& overlaps) {
  const OverlapAnswer answer = answer_of_overlap(offer, offered, requested, vocabulary, overlaps);
  if (answer == nullptr || answer->verdict != Overlap::Verdict::possible) return std::nullopt;
  return Match{Degree::overlapping, answer->distance};
}

}  // namespace geminga::matching
