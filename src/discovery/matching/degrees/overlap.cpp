#include "discovery/matching/degrees/overlap.hpp"

#include "reasoning/vocabulary/expression.hpp"

namespace geminga::matching {

using vocabulary::Overlap;

OverlapAnswer decided_at_once(const vocabulary::Vocabulary& vocabulary, vocabulary::ClassNumber offered,
                              const SemanticIdentity& requested, const Classes& requested_classes) {
  if (!requested_classes.place) {
    return std::make_shared<const Overlap>(vocabulary.overlap(offered, requested_classes.concept_class.value()));
  }
  if (const auto ready = vocabulary.check_expressions(); !ready)
    return std::make_shared<const Overlap>(Overlap{.reason = ready.error().text});
  const auto expression = vocabulary.read(requested.concept_iri, vocabulary::max_expression_bytes);
  if (!expression) return std::make_shared<const Overlap>(Overlap{.reason = expression.error().text});
  return std::make_shared<const Overlap>(vocabulary.overlap(offered, *expression, *requested_classes.place));
}

OverlapAnswer answer_of_overlap(const Classes& offered, const Classes& requested,
                                const vocabulary::Vocabulary& vocabulary, const AskOverlap& overlaps) {
  const bool has_classes = offered.concept_class && (requested.concept_class || requested.place);
  return overlaps && has_classes ? overlaps(vocabulary, *offered.concept_class) : nullptr;
}

std::optional<Match> degree_of_overlap(const Classes& offered, const Classes& requested,
                                       const vocabulary::Vocabulary& vocabulary, const AskOverlap& overlaps) {
  const OverlapAnswer answer = answer_of_overlap(offered, requested, vocabulary, overlaps);
  if (answer == nullptr || answer->verdict != Overlap::Verdict::possible) return std::nullopt;
  return Match{Degree::overlapping, answer->distance};
}

}  // namespace geminga::matching
