// How an offered identity meets a requested one, by the ontology or, where it knows nothing, by the identifier alone.
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
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/placement/expression.hpp"

namespace geminga::matching {

/// How an offer meets a request.
struct Match {
  Degree degree = Degree::exact;
  std::uint32_t distance = 0;  ///< taxonomy edges of the concept plus those of the representation
  friend auto operator<=>(const Match&, const Match&) = default;
};

/// The classes of a semantic identity in one ontology. A name that the ontology does not know has no class here, and
/// neither has an unsatisfiable one: it is below everything only because nothing can be an instance of it, so a service
/// that offers it has no instance to give and one that asks for it none to take. Both match exactly or not at all.
struct Classes {
  std::optional<taxonomy::ClassNumber> concept_class;
  std::optional<taxonomy::ClassNumber> representation_class;
  /// Where the expression stands that is asked for instead of a concept; null where there is none or it is not known.
  std::shared_ptr<const placement::ExpressionPlace> place{};
};

/// Gives the place of a canonical expression in the ontology that the matcher works with, or null where it is not known
/// (yet), or nothing can be an instance of it. `from` says who asks: its own participant, or one on the air.
using Placing =
    std::function<std::shared_ptr<const placement::ExpressionPlace>(const std::string& expression, ParticipantId from)>;

/// Looks up both names. `ontology` may be null: then there are no classes.
[[nodiscard]] Classes classes_of(const Identity& identity, const compiled::Ontology* ontology);

/// The degree of one name, a concept or a representation: exact for equal identifiers, otherwise by subsumption between
/// the classes, which needs both. Nothing where neither subsumes the other.
[[nodiscard]] std::optional<Match> degree_of_name(const std::string& offered_iri,
                                                  std::optional<taxonomy::ClassNumber> offered,
                                                  const std::string& requested_iri,
                                                  std::optional<taxonomy::ClassNumber> requested,
                                                  const compiled::Ontology* ontology);

/// The degree of a concept against an expression: that which it would have against a class in this place, and the
/// distance that it would have (el/expression.hpp).
[[nodiscard]] std::optional<Match> degree_of_expression(std::optional<taxonomy::ClassNumber> offered,
                                                        const placement::ExpressionPlace* requested,
                                                        const compiled::Ontology* ontology);

/// Whether the first is a number and the second a concept with that 32-bit identity.
[[nodiscard]] bool is_number_of(const Identity& number, const Identity& named);

/// The degree of the whole identity, however weak; the caller compares it with what the subscription allows. Identities
/// of different kinds never match, but for a number and the concept whose 32-bit identity it is: exactly. Numbers and
/// texts match only when they are equal.
[[nodiscard]] std::optional<Match> degree_of_identity(const Identity& offered, const Classes& offered_classes,
                                                      const Identity& requested, const Classes& requested_classes,
                                                      const compiled::Ontology* ontology);

}  // namespace geminga::matching

#endif
