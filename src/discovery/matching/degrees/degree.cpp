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

std::optional<Match> degree_of_name(const NamedClass& offered, const NamedClass& requested,
                                    const vocabulary::Vocabulary& vocabulary) {
  if (offered.iri == requested.iri) return Match{Degree::exact, 0};
  if (!offered.number || !requested.number) return std::nullopt;
  if (const auto up = vocabulary.distance(*offered.number, *requested.number)) {
    if (vocabulary.is_subsumed(*requested.number, *offered.number)) return Match{Degree::equivalent, 0};
    return Match{Degree::narrower, *up};
  }
  if (const auto down = vocabulary.distance(*requested.number, *offered.number)) return Match{Degree::broader, *down};
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

std::optional<Match> degree_of_concept(const Meaning& offered, const Meaning& requested,
                                       const vocabulary::Vocabulary& vocabulary, const AskComparison& compares) {
  if (offered.identity.concept_iri == requested.identity.concept_iri) return Match{Degree::exact, 0};
  if (offered.classes.place && requested.classes.place) {
    if (!compares) return std::nullopt;
    const auto answer = compares(vocabulary, offered);
    return answer == nullptr ? std::nullopt : degree_of_comparison(*answer);
  }
  if (has_expression(requested.identity)) {
    return degree_of_expression(offered.classes.concept_class, requested.classes.place.get(), vocabulary);
  }
  if (has_expression(offered.identity)) {
    return degree_of_expression(offered.classes.place.get(), requested.classes.concept_class, vocabulary);
  }
  return degree_of_name(offered.named_concept(), requested.named_concept(), vocabulary);
}

std::optional<Match> degree_of_identity(const Side& offered, const Side& requested,
                                        const vocabulary::Vocabulary& vocabulary, std::uint32_t convert,
                                        const Questions& asks) {
  const auto* semantic_offer = std::get_if<SemanticIdentity>(&offered.identity);
  const auto* semantic_request = std::get_if<SemanticIdentity>(&requested.identity);
  if (semantic_offer == nullptr || semantic_request == nullptr) {
    const bool is_met = offered.identity == requested.identity || is_number_of(offered.identity, requested.identity) ||
                        is_number_of(requested.identity, offered.identity);
    return is_met ? std::optional(Match{Degree::exact, 0}) : std::nullopt;
  }
  const Meaning offer{*semantic_offer, offered.classes};
  const Meaning request{*semantic_request, requested.classes};
  auto by_concept = degree_of_concept(offer, request, vocabulary, asks.compares);
  if (!by_concept && !asks.overlaps) return std::nullopt;
  const auto by_representation =
      degree_of_representation(offer.representation(), request.representation(), vocabulary, convert, asks.chains);
  if (!by_representation) return std::nullopt;
  // Asked last, because the reasoner has to search.
  if (!by_concept) by_concept = degree_of_overlap(offer, requested.classes, vocabulary, asks.overlaps);
  if (!by_concept) return std::nullopt;
  if (by_representation->degree == Degree::exact) return by_concept;
  // An identity whose concept has no class here matches exactly or not at all, whatever its representation.
  if (!has_meaning(offered.classes) || !has_meaning(requested.classes)) return std::nullopt;
  return combined(*by_concept, *by_representation);
}

}  // namespace geminga::matching
