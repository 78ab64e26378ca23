#include "discovery/matching/degrees/degree.hpp"

#include <algorithm>
#include <variant>

#include "base/text.hpp"
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

bool may_be_missed(vocabulary::ClassNumber offered, const vocabulary::Place& requested, bool is_broader_enough,
                   const vocabulary::Vocabulary& vocabulary) {
  if (requested.gaps.empty()) return false;
  const auto is_below = [&](vocabulary::ClassNumber parent) { return vocabulary.is_subsumed(offered, parent); };
  const auto is_above = [&](vocabulary::ClassNumber child) { return vocabulary.is_subsumed(child, offered); };
  return std::ranges::all_of(requested.parents, is_below) ||
         (is_broader_enough && std::ranges::all_of(requested.children, is_above));
}

std::string gap_words(const Classes& requested) {
  if (requested.place == nullptr) return "";
  return base::printable(base::joined(requested.place->gaps, ", "), max_gap_bytes);
}

bool is_number_of(const Identity& number, const Identity& named) {
  const auto* numeric = std::get_if<NumericIdentity>(&number);
  return numeric != nullptr && std::holds_alternative<SemanticIdentity>(named) && !has_expression(named) &&
         numeric->number == id32(named);
}

std::optional<Match> degree_of_concept(const SemanticIdentity& offered, const Classes& offered_classes,
                                       const SemanticIdentity& requested, const Classes& requested_classes,
                                       const vocabulary::Vocabulary& vocabulary) {
  if (has_expression(requested) && offered.concept_iri != requested.concept_iri) {
    return degree_of_expression(offered_classes.concept_class, requested_classes.place.get(), vocabulary);
  }
  return degree_of_name(offered.concept_iri, offered_classes.concept_class, requested.concept_iri,
                        requested_classes.concept_class, vocabulary);
}

std::optional<Match> degree_of_identity(const Identity& offered, const Classes& offered_classes,
                                        const Identity& requested, const Classes& requested_classes,
                                        const vocabulary::Vocabulary& vocabulary, std::uint32_t convert,
                                        const AskOverlap& overlaps, const AskChain& chains) {
  const auto* offer = std::get_if<SemanticIdentity>(&offered);
  const auto* request = std::get_if<SemanticIdentity>(&requested);
  if (offer == nullptr || request == nullptr) {
    const bool is_met = offered == requested || is_number_of(offered, requested) || is_number_of(requested, offered);
    return is_met ? std::optional(Match{Degree::exact, 0}) : std::nullopt;
  }
  auto by_concept = degree_of_concept(*offer, offered_classes, *request, requested_classes, vocabulary);
  if (!by_concept && !overlaps) return std::nullopt;
  const auto by_representation = degree_of_representation(
      offer->representation_iri, offered_classes.representation_class, request->representation_iri,
      requested_classes.representation_class, vocabulary, convert, chains);
  if (!by_representation) return std::nullopt;
  // Asked last, because the reasoner has to search.
  if (!by_concept) by_concept = degree_of_overlap(offered_classes, requested_classes, vocabulary, overlaps);
  if (!by_concept) return std::nullopt;
  if (by_representation->degree == Degree::exact) return by_concept;
  // An identity whose concept has no class here matches exactly or not at all, whatever its representation.
  const bool has_classes =
      offered_classes.concept_class && (requested_classes.concept_class || requested_classes.place);
  if (!has_classes) return std::nullopt;
  return combined(*by_concept, *by_representation);
}

}  // namespace geminga::matching
