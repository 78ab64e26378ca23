// The degree of match of an offered and a requested identity, by the vocabulary or, where it knows neither, by name.
#ifndef GEMINGA_DISCOVERY_MATCHING_DEGREES_DEGREE_HPP
#define GEMINGA_DISCOVERY_MATCHING_DEGREES_DEGREE_HPP

#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "geminga/identity.hpp"
#include "geminga/match.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// How well an offer meets a request.
struct Match {
  Degree degree = Degree::exact;
  std::uint32_t distance = 0;  ///< taxonomy edges of the concept plus those of the representation
  std::uint32_t cost = 0;      ///< of converting the representation; 0: it is not converted
  std::uint32_t chain = 0;     ///< vocabulary::Chain::mark of the conversion; 0: it is not converted
  friend bool operator==(const Match&, const Match&) = default;
  /// Orders the better one first: by degree, cost and distance. Different chains of one cost are equally good.
  friend std::weak_ordering operator<=>(const Match& a, const Match& b) {
    if (a.degree != b.degree) return weakness(a.degree) <=> weakness(b.degree);
    if (a.cost != b.cost) return a.cost <=> b.cost;
    return a.distance <=> b.distance;
  }
};

/// The classes of a semantic identity in one vocabulary. A name that the vocabulary does not know has no class here. An
/// unsatisfiable class counts as none: it is below every other class, but has no instance that could be given or
/// taken. Identities without classes match exactly or not at all.
struct Classes {
  std::optional<vocabulary::ClassNumber> concept_class{};
  std::optional<vocabulary::ClassNumber> representation_class{};
  /// The place of an expression that stands for a concept; null: it is no expression, or has no place.
  std::shared_ptr<const vocabulary::Place> place{};
};

/// Whether something is known of the concept, a class or the place of an expression.
[[nodiscard]] inline bool has_meaning(const Classes& classes) { return classes.concept_class || classes.place; }

/// A name, with its class in one vocabulary if it has one. Borrows the name.
struct NamedClass {
  const std::string& iri;
  std::optional<vocabulary::ClassNumber> number;
};

/// A semantic identity with its classes in one vocabulary. Borrows both.
struct Meaning {
  const SemanticIdentity& identity;
  const Classes& classes;

  [[nodiscard]] NamedClass named_concept() const { return {identity.concept_iri, classes.concept_class}; }
  [[nodiscard]] NamedClass representation() const {
    return {identity.representation_iri, classes.representation_class};
  }
};

/// One side of a pair, what is offered or what is asked for: its identity with its classes. Borrows both.
struct Side {
  const Identity& identity;
  const Classes& classes;
};

/// Gives the place of a canonical expression in a vocabulary; null where it is not known (yet) or has no instances.
/// `from` is the participant that states it.
using Placing = std::function<std::shared_ptr<const vocabulary::Place>(
    const vocabulary::Vocabulary& vocabulary, const std::string& expression, ParticipantId from)>;

/// Says for one request whether an offered concept overlaps with what it asks for; null: that waits to be decided.
/// Empty where the request does not accept overlapping concepts (overlap.hpp).
using AskOverlap = std::function<std::shared_ptr<const vocabulary::Overlap>(const vocabulary::Vocabulary& vocabulary,
                                                                            const Meaning& offered)>;

/// Says for a request for an expression how an offered expression, the first, relates to it; null: that waits to be
/// decided. Empty where the request is for no expression. Asked only about two that have places (comparison.hpp).
using AskComparison = std::function<std::shared_ptr<const vocabulary::Comparison>(
    const vocabulary::Vocabulary& vocabulary, const Meaning& offered)>;

/// Gives for one request the cheapest chain from an offered representation to a requested one; null where there is
/// none. Empty: chains of declared conversions alone.
using AskChain = std::function<std::shared_ptr<const vocabulary::Chain>(vocabulary::ClassNumber offered,
                                                                        vocabulary::ClassNumber requested)>;

/// The questions of a request to the reasoner and the converters while it is compared.
struct Questions {
  AskOverlap overlaps{};     ///< asked about concepts that have no other degree; empty: overlapping ones do not count
  AskComparison compares{};  ///< asked about two expressions; empty: it is for no expression that has a place
  AskChain chains{};         ///< asked about representations to be converted; empty: declared conversions alone
};

/// Looks up the concept and the representation.
[[nodiscard]] Classes classes_of(const Identity& identity, const vocabulary::Vocabulary& vocabulary);

/// The degree of one name, a concept or a representation: exact for equal names, otherwise by subsumption between the
/// two classes. Nothing where one has no class or neither subsumes the other.
[[nodiscard]] std::optional<Match> degree_of_name(const NamedClass& offered, const NamedClass& requested,
                                                  const vocabulary::Vocabulary& vocabulary);

/// The degree and distance of an offered class against an expression that is asked for, and of an offered expression
/// against a class: those of a class in the expression's place (reasoning/placement/expression.hpp).
[[nodiscard]] std::optional<Match> degree_of_expression(std::optional<vocabulary::ClassNumber> offered,
                                                        const vocabulary::Place* requested,
                                                        const vocabulary::Vocabulary& vocabulary);
[[nodiscard]] std::optional<Match> degree_of_expression(const vocabulary::Place* offered,
                                                        std::optional<vocabulary::ClassNumber> requested,
                                                        const vocabulary::Vocabulary& vocabulary);

/// Whether concepts without a degree, one of them an expression, may be related all the same, because a place has gaps:
/// the offered one may be below the requested one, or with `is_broader_enough` above it, for all that is known.
[[nodiscard]] bool may_be_missed(const Classes& offered, const Classes& requested, bool is_broader_enough,
                                 const vocabulary::Vocabulary& vocabulary);

/// The reasons in words why the place of an expression may be incomplete; empty where it is complete.
[[nodiscard]] std::string gap_words(const Classes& classes);
/// Those of either.
[[nodiscard]] std::string gap_words(const Classes& offered, const Classes& requested);

/// Whether the first is a number and the second a concept with that 32-bit identity.
[[nodiscard]] bool is_number_of(const Identity& number, const Identity& named);

/// The degree of the concepts alone, however weak.
[[nodiscard]] std::optional<Match> degree_of_concept(const Meaning& offered, const Meaning& requested,
                                                     const vocabulary::Vocabulary& vocabulary,
                                                     const AskComparison& compares);

/// The degree of the whole identity, however weak: the caller compares it with the weakest that the subscription
/// allows. Numbers and texts match only when they are equal. Identities of different kinds never match, but for one
/// exception: a number matches exactly the concept whose 32-bit identity it is. `convert` is the largest cost of a
/// conversion that is accepted.
[[nodiscard]] std::optional<Match> degree_of_identity(const Side& offered, const Side& requested,
                                                      const vocabulary::Vocabulary& vocabulary,
                                                      std::uint32_t convert = 0, const Questions& asks = {});

}  // namespace geminga::matching

#endif
