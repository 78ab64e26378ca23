// How an offered identity meets a requested one, by the vocabulary or, where it knows nothing, by the identifier alone.
#ifndef GEMINGA_DISCOVERY_MATCHING_DEGREE_HPP
#define GEMINGA_DISCOVERY_MATCHING_DEGREE_HPP

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

/// How an offer meets a request.
struct Match {
  Degree degree = Degree::exact;
  std::uint32_t distance = 0;  ///< taxonomy edges of the concept plus those of the representation
  std::uint32_t cost = 0;      ///< of turning the representation into what is asked for; 0: it need not be
  std::uint32_t chain = 0;     ///< vocabulary::Chain::mark of how; 0: it need not be
  friend bool operator==(const Match&, const Match&) = default;
  /// The better one first: by degree, cost and distance. Different chains of one cost are equally good.
  friend std::weak_ordering operator<=>(const Match& a, const Match& b) {
    if (a.degree != b.degree) return weakness(a.degree) <=> weakness(b.degree);
    if (a.cost != b.cost) return a.cost <=> b.cost;
    return a.distance <=> b.distance;
  }
};

/// The classes of a semantic identity in one vocabulary. A name that the vocabulary does not know has no class here,
/// and neither has an unsatisfiable one: it is below everything only because nothing can be an instance of it, so a
/// service that offers it has no instance to give and one that asks for it none to take. Both match exactly or not at
/// all.
struct Classes {
  std::optional<vocabulary::ClassNumber> concept_class;
  std::optional<vocabulary::ClassNumber> representation_class;
  /// The place of the expression that is asked for instead of a concept; null: there is none, or it is not known.
  std::shared_ptr<const vocabulary::Place> place{};
};

/// Gives the place of a canonical expression in a vocabulary, or null where it is not known (yet), or nothing can be an
/// instance of it. `from` says who asks: its own participant, or one on the air.
using Placing = std::function<std::shared_ptr<const vocabulary::Place>(
    const vocabulary::Vocabulary& vocabulary, const std::string& expression, ParticipantId from)>;

/// Whether a class that is offered can have instances in common with what a request asks for; null: that waits to be
/// decided. Empty where the request does not accept that (overlap.hpp).
using AskOverlap = std::function<std::shared_ptr<const vocabulary::Overlap>(const vocabulary::Vocabulary& vocabulary,
                                                                            vocabulary::ClassNumber offered)>;

/// The cheapest chain that turns what is in a class that is offered into a class that a request asks for, for that
/// request; null where there is none. Empty: that of declared conversions alone.
using AskChain = std::function<std::shared_ptr<const vocabulary::Chain>(vocabulary::ClassNumber offered,
                                                                        vocabulary::ClassNumber requested)>;

/// Looks up both names.
[[nodiscard]] Classes classes_of(const Identity& identity, const vocabulary::Vocabulary& vocabulary);

/// The degree of one name, a concept or a representation: exact for equal identifiers, otherwise by subsumption between
/// the classes, which needs both. Nothing where neither subsumes the other.
[[nodiscard]] std::optional<Match> degree_of_name(const std::string& offered_iri,
                                                  std::optional<vocabulary::ClassNumber> offered,
                                                  const std::string& requested_iri,
                                                  std::optional<vocabulary::ClassNumber> requested,
                                                  const vocabulary::Vocabulary& vocabulary);

/// The degree of a concept against an expression: that which it would have against a class in this place, and the
/// distance that it would have (reasoning/placement/expression.hpp).
[[nodiscard]] std::optional<Match> degree_of_expression(std::optional<vocabulary::ClassNumber> offered,
                                                        const vocabulary::Place* requested,
                                                        const vocabulary::Vocabulary& vocabulary);

/// Whether a class that has no degree against an expression may be below it all the same, because the place has gaps:
/// it is below all that is known to be above the expression. With `is_broader_enough` also whether it may be above it.
[[nodiscard]] bool may_be_missed(vocabulary::ClassNumber offered, const vocabulary::Place& requested,
                                 bool is_broader_enough, const vocabulary::Vocabulary& vocabulary);

/// Why the place of the expression that is asked for may miss something, in few words; empty where nothing is missing.
[[nodiscard]] std::string gap_words(const Classes& requested);

/// Whether the first is a number and the second a concept with that 32-bit identity.
[[nodiscard]] bool is_number_of(const Identity& number, const Identity& named);

/// The degree of the concept alone, offered and requested, however weak.
[[nodiscard]] std::optional<Match> degree_of_concept(const SemanticIdentity& offered, const Classes& offered_classes,
                                                     const SemanticIdentity& requested,
                                                     const Classes& requested_classes,
                                                     const vocabulary::Vocabulary& vocabulary);

/// The degree of the whole identity, however weak; the caller compares it with what the subscription allows. Identities
/// of different kinds never match, with one exception: a number matches exactly the concept whose 32-bit identity it
/// is. Numbers and texts match only when they are equal. `convert` is the largest cost of conversions that counts,
/// `overlaps` says of concepts that have no degree otherwise whether they overlap, `chains` who converts.
[[nodiscard]] std::optional<Match> degree_of_identity(const Identity& offered, const Classes& offered_classes,
                                                      const Identity& requested, const Classes& requested_classes,
                                                      const vocabulary::Vocabulary& vocabulary,
                                                      std::uint32_t convert = 0, const AskOverlap& overlaps = {},
                                                      const AskChain& chains = {});

}  // namespace geminga::matching

#endif
