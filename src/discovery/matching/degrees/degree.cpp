#include "discovery/matching/degrees/degree.hpp"

#include <algorithm>
#include <variant>

#include "base/text.hpp"
#include "discovery/matching/degrees/comparison.hpp"
#include "discovery/matching/degrees/overlap.hpp"
#include "discovery/matching/degrees/representation.hpp"

namespace geminga::matching {
namespace {

constexpr std::size_t max_gap_bytes = 400;

std::optional<vocabulary::ClassNumber> class_of(const std::string& iri, const vocabulary::Vocabulary& vocabulary) {
  const auto number = vocabulary.find_iri(iri);
  if (!number || !vocabulary.is_satisfiable(*number)) return std::nullopt;
  return number;
}

}  // namespace

Classes classes_of(const Identity& identity, const vocabulary::Vocabulary& vocabulary) {
  const auto* semantic = std::get_if<SemanticIdentity>(&identity);
  if (semantic == nullptr) return {};
  Classes classes;
  if (!has_expression(*semantic)) classes.concept_class = class_of(semantic->concept_iri, vocabulary);
  if (!semantic->representation_iri.empty()) {
    classes.representation_class = class_of(semantic->representation_iri, vocabulary);
  }
  return classes;
}

std::optional<Match> degree_of_name(const std::string& offered_iri, std::optional<vocabulary::ClassNumber> offered,
                                    const std::string& requested_iri, std::optional<vocabulary::ClassNumber> requested,
                                    const vocabulary::Vocabulary& vocabulary) {
  if (offered_iri == requested_iri) return Match{Degree::exact, 0};
  if (!offered || !requested) return std::nullopt;
  if (const auto up = vocabulary.distance(*offered, *requested)) {
    if (vocabulary.is_subsumed(*requested, *offered)) return Match{Degree::equivalent, 0};
    return Match{Degree::narrower, *up};
  }
  if (const auto down = vocabulary.distance(*requested, *offered)) return Match{Degree::broader, *down};
  return std::nullopt;
}

std::optional<Match> degree_of_expression(std::optional<vocabulary::ClassNumber> offered,
                                          const vocabulary::Place* requested,
                                          const vocabulary::Vocabulary& vocabulary) {
  if (!offered || requested == nullptr || !requested->is_satisfiable) return std::nullopt;
  const auto up = vocabulary.distance_down(*requested, *offered);
  if (up) return *up == 0 ? Match{Degree::equivalent, 0} : Match{Degree::narrower, *up};
  if (const auto down = vocabulary.distance_up(*requested, *offered)) return Match{Degree::broader, *down};
  return std::nullopt;
}

std::optional<Match> degree_of_expression(const vocabulary::Place* offered,
                                          std::optional<vocabulary::ClassNumber> requested,
                                          const vocabulary::Vocabulary& vocabulary) {
  if (!requested || offered == nullptr || !offered->is_satisfiable) return std::nullopt;
  const auto up = vocabulary.distance_up(*offered, *requested);
  if (up) return *up == 0 ? Match{Degree::equivalent, 0} : Match{Degree::narrower, *up};
  if (const auto down = vocabulary.distance_down(*offered, *requested)) return Match{Degree::broader, *down};
  return std::nullopt;
}

bool may_be_missed(const Classes& offered, const Classes& requested, bool is_broader_enough,
                   const vocabulary::Vocabulary& vocabulary) {
  const auto has_gaps = [](const Classes& one) { return one.place && !one.place->gaps.empty(); };
  if (!has_meaning(offered) || !has_meaning(requested)) return false;
  if (offered.place && requested.place) return has_gaps(offered) || has_gaps(requested);
  if (!has_gaps(offered) && !has_gaps(requested)) return false;
  // One is a class, and may be below the other if it is below all that is known above it.
  const vocabulary::ClassNumber named = offered.place ? *requested.concept_class : *offered.concept_class;
  const vocabulary::Place& place = offered.place ? *offered.place : *requested.place;
  const bool may_be_under = std::ranges::all_of(
      place.parents, [&](vocabulary::ClassNumber parent) { return vocabulary.is_subsumed(named, parent); });
  const bool may_be_over = std::ranges::all_of(
      place.children, [&](vocabulary::ClassNumber child) { return vocabulary.is_subsumed(child, named); });
  return (offered.place ? may_be_over : may_be_under) || (is_broader_enough && (may_be_under || may_be_over));
}

std::string gap_words(const Classes& classes) {
  if (classes.place == nullptr) return "";
  return base::printable(base::joined(classes.place->gaps, ", "), max_gap_bytes);
}

std::string gap_words(const Classes& offered, const Classes& requested) {
  const std::string one = gap_words(offered);
  const std::string other = gap_words(requested);
  if (one.empty() || other.empty() || one == other) return one.empty() ? other : one;
  return one + ", " + other;
}

bool is_number_of(const Identity& number, const Identity& named) {
  const auto* numeric = std::get_if<NumericIdentity>(&number);
  return numeric != nullptr && std::holds_alternative<SemanticIdentity>(named) && !has_expression(named) &&
         numeric->number == id32(named);
}

std::optional<Match> degree_of_concept(const SemanticIdentity& offered, const Classes& offered_classes,
                                       const SemanticIdentity& requested, const Classes& requested_classes,
                                       const vocabulary::Vocabulary& vocabulary, const AskComparison& compares) {
  if (offered.concept_iri == requested.concept_iri) return Match{Degree::exact, 0};
  if (offered_classes.place && requested_classes.place) {
    if (!compares) return std::nullopt;
    const auto answer = compares(vocabulary, offered, offered_classes);
    return answer == nullptr ? std::nullopt : degree_of_comparison(*answer);
  }
  if (has_expression(requested)) {
    return degree_of_expression(offered_classes.concept_class, requested_classes.place.get(), vocabulary);
  }
  if (has_expression(offered)) {
    return degree_of_expression(offered_classes.place.get(), requested_classes.concept_class, vocabulary);
  }
  return degree_of_name(offered.concept_iri, offered_classes.concept_class, requested.concept_iri,
                        requested_classes.concept_class, vocabulary);
}

std::optional<Match> degree_of_identity(const Identity& offered, const Classes& offered_classes,
                                        const Identity& requested, const Classes& requested_classes,
                                        const vocabulary::Vocabulary& vocabulary, std::uint32_t convert,
                                        const AskOverlap& overlaps, const AskChain& chains,
                                        const AskComparison& compares) {
  const auto* offer = std::get_if<SemanticIdentity>(&offered);
  const auto* request = std::get_if<SemanticIdentity>(&requested);
  if (offer == nullptr || request == nullptr) {
    const bool is_met = offered == requested || is_number_of(offered, requested) || is_number_of(requested, offered);
    return is_met ? std::optional(Match{Degree::exact, 0}) : std::nullopt;
  }
  auto by_concept = degree_of_concept(*offer, offered_classes, *request, requested_classes, vocabulary, compares);
  if (!by_concept && !overlaps) return std::nullopt;
  const auto by_representation = degree_of_representation(
      offer->representation_iri, offered_classes.representation_class, request->representation_iri,
      requested_classes.representation_class, vocabulary, convert, chains);
  if (!by_representation) return std::nullopt;
  // Asked last, because the reasoner has to search.
  if (!by_concept) by_concept = degree_of_overlap(*offer, offered_classes, requested_classes, vocabulary, overlaps);
  if (!by_concept) return std::nullopt;
  if (by_representation->degree == Degree::exact) return by_concept;
  // An identity whose concept has no class here matches exactly or not at all, whatever its representation.
  if (!has_meaning(offered_classes) || !has_meaning(requested_classes)) return std::nullopt;
  return combined(*by_concept, *by_representation);
}

}  // namespace geminga::matching
