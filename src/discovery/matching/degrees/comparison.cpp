#include "discovery/matching/degrees/comparison.hpp"

#include "reasoning/vocabulary/expression.hpp"

namespace geminga::matching {

using vocabulary::Comparison;

ComparisonAnswer compared_at_once(const vocabulary::Vocabulary& vocabulary, const Meaning& offered,
                                  const Meaning& requested) {
  const vocabulary::Place& place = *offered.classes.place;
  const vocabulary::Place& place_of_request = *requested.classes.place;
  if (const auto by_place = vocabulary.compare(place, place_of_request)) {
    return std::make_shared<const Comparison>(*by_place);
  }
  const auto undecided = [](const Error& error) {
    return std::make_shared<const Comparison>(Comparison{.gaps = {error.text}});
  };
  if (const auto ready = vocabulary.check_expressions(); !ready) return undecided(ready.error());
  const auto one = vocabulary.read(offered.identity.concept_iri, vocabulary::max_expression_bytes);
  if (!one) return undecided(one.error());
  const auto other = vocabulary.read(requested.identity.concept_iri, vocabulary::max_expression_bytes);
  if (!other) return undecided(other.error());
  return std::make_shared<const Comparison>(vocabulary.compare(*one, place, *other, place_of_request));
}

std::optional<Match> degree_of_comparison(const Comparison& comparison) {
  switch (comparison.relation) {
    case Comparison::Relation::equivalent:
      return Match{Degree::equivalent, 0};
    case Comparison::Relation::narrower:
      return Match{Degree::narrower, comparison.distance};
    case Comparison::Relation::broader:
      return Match{Degree::broader, comparison.distance};
    case Comparison::Relation::apart:
      break;
  }
  return std::nullopt;
}

}  // namespace geminga::matching
