// The clausal form of an ontology: what both engines beyond EL work on.
//
// A clause  L1 and ... and Lm -> R1 or ... or Rn  holds for every x and every y1..yk around it (Motik, Shearer,
// Horrocks: Hypertableau Reasoning for Description Logics, 2009, section 4; Bate et al.: Consequence-Based Reasoning
// for SRIQ, 2018, section 3). An empty body is true, an empty head is false. Inverse properties are written by turning
// the arguments round: R-(x, y) is R(y, x).
//
// Legend: A B concepts, R S object properties, U data properties, D data ranges, x the centre, y y1 y2 its neighbours,
// v v1 v2 values, >= n R.B "at least n R neighbours in B", <= n R.B "at most n".
#ifndef GEMINGA_REASONING_DL_CLAUSES_CLAUSE_HPP
#define GEMINGA_REASONING_DL_CLAUSES_CLAUSE_HPP

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "reasoning/dl/clauses/rule.hpp"
#include "reasoning/owl/automaton.hpp"
#include "reasoning/owl/axiom.hpp"
#include "reasoning/owl/role.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::clauses {

/// A unary predicate over things: a named class, a nominal {a}, or a name for a class expression. Dense.
enum class ConceptId : std::uint32_t {};
inline constexpr ConceptId thing{0};
inline constexpr ConceptId nothing{1};
/// The term of an individual that only the translation needs, which has none in the source.
inline constexpr owl::TermId no_term{0xffffffffU};
using owl::PropertyId;
using owl::Role;
/// A data property. Dense.
enum class DataPropertyId : std::uint32_t {};
/// A unary predicate over values: a data range or the complement of one. Dense; see DataRange.
enum class DataRangeId : std::uint32_t {};
/// An individual, named or anonymous. Dense.
enum class IndividualId : std::uint32_t {};

template <typename Id>
[[nodiscard]] constexpr std::uint32_t number(Id id) {
  return static_cast<std::uint32_t>(id);
}

/// The variables of a clause: 0 is the centre x, others are its neighbours y1, y2, ... (or values v1, v2, ...).
using Variable = std::uint8_t;
inline constexpr Variable centre = 0;

enum class AtomKind : std::uint8_t {
  concept_of,     ///< B(first)
  role,           ///< R(first, second): one of them is the centre, or both are
  equal,          ///< first = second; heads only
  at_least,       ///< (>= n R.B)(x), predicate is an index of ClauseSet::at_leasts; heads only
  data_role,      ///< U(x, second)
  data_range,     ///< D(first), about a value; heads only (a range in a body stands as its complement in the head)
  data_equal,     ///< values first = second; heads only
  data_at_least,  ///< (>= n U.D)(x), an index of ClauseSet::data_at_leasts; heads only
  at_most,        ///< (<= n R.B)(x), an index of ClauseSet::at_mosts; heads only, and only where n > inline_at_most
  data_at_most,   ///< (<= n U.D)(x), an index of ClauseSet::data_at_mosts; the same
};

/// Up to this n, <= n R.B is a clause with equalities: R(x,y1), B(y1), ..., R(x,yn+1), B(yn+1) -> y1=y2, y1=y3, ...
/// Their number grows with the square of n, so for greater n it is one atom.
inline constexpr std::uint32_t inline_at_most = 4;

struct Atom {
  AtomKind kind = AtomKind::concept_of;
  Variable first = centre;
  Variable second = centre;
  std::uint32_t predicate = 0;  ///< number of a ConceptId, PropertyId, DataPropertyId, DataRangeId, or an index
  friend auto operator<=>(const Atom&, const Atom&) = default;
};

struct Clause {
  std::vector<Atom> body;
  std::vector<Atom> head;
  friend auto operator<=>(const Clause&, const Clause&) = default;
};

/// >= count role.filler
struct AtLeast {
  std::uint32_t count = 1;
  Role role;
  ConceptId filler = thing;
  friend auto operator<=>(const AtLeast&, const AtLeast&) = default;
};
struct DataAtLeast {
  std::uint32_t count = 1;
  DataPropertyId property{};
  DataRangeId range{};  ///< 0 is rdfs:Literal, every value
  friend auto operator<=>(const DataAtLeast&, const DataAtLeast&) = default;
};

/// <= count role.filler
struct AtMost {
  std::uint32_t count = 0;
  Role role;
  ConceptId filler = thing;
  friend auto operator<=>(const AtMost&, const AtMost&) = default;
};
struct DataAtMost {
  std::uint32_t count = 0;
  DataPropertyId property{};
  DataRangeId range{};
  DataRangeId outside{};  ///< its complement: values in this one are not counted
  friend auto operator<=>(const DataAtMost&, const DataAtMost&) = default;
};

/// The values that a DataRangeId stands for.
struct DataRange {
  /// A datatype, a data range expression, or a literal, which stands for the range of its one value.
  owl::TermId term{};
  bool is_complement = false;  ///< every value that is not in it
  friend auto operator<=>(const DataRange&, const DataRange&) = default;
};
/// DatatypeDefinition(datatype range): in terms, `datatype` means `range`.
struct DatatypeDefinition {
  owl::TermId datatype{};
  owl::TermId range{};
};

/// Named individuals in `of` that share a value of each of these properties are equal. Values of object properties
/// count if they are named individuals, too.
struct Key {
  ConceptId of{};
  std::vector<Role> roles;
  std::vector<DataPropertyId> data_properties;
  friend auto operator<=>(const Key&, const Key&) = default;
};

enum class ConceptKind : std::uint8_t {
  named,     ///< term: the named class
  nominal,   ///< the one instance is `individual`; term: the individual
  mark,      ///< stands for the nominal of `individual` where only bodies ask for it (body_nominals.hpp)
  auxiliary  ///< stands for a class expression, a state of a property's automaton, or a group of disjoint classes
};
struct Concept {
  ConceptKind kind = ConceptKind::named;
  owl::TermId term{};
  IndividualId individual{};
};

/// The facts. Negative facts are clauses over nominals.
struct ConceptFact {
  ConceptId of{};
  IndividualId individual{};
};
struct RoleFact {
  PropertyId property{};
  IndividualId first{};
  IndividualId second{};
};
/// `value` is a literal term of the source.
struct DataFact {
  DataPropertyId property{};
  IndividualId individual{};
  owl::TermId value{};
};
struct Equality {
  IndividualId first{};
  IndividualId second{};
  bool is_negated = false;  ///< they are different
};

/// An axiom of the source that the clauses do not contain, or not in full.
struct Unused {
  std::uint32_t axiom = 0;
  std::string_view construct;  ///< the words of owl::to_string(owl::Construct), or others as short
};

/// The whole ontology. Tables are indexed by the numbers of the ids.
struct ClauseSet {
  std::vector<Concept> concepts;        ///< [0] is owl:Thing, [1] owl:Nothing
  std::vector<owl::TermId> properties;  ///< the object property
  std::vector<owl::TermId> data_properties;
  std::vector<DataRange> data_ranges;  ///< [0] is rdfs:Literal, every value, whatever its term; [1] no value
  std::vector<DatatypeDefinition> datatype_definitions;
  std::vector<owl::TermId> individuals;
  std::vector<AtLeast> at_leasts;
  std::vector<DataAtLeast> data_at_leasts;
  std::vector<AtMost> at_mosts;
  std::vector<DataAtMost> data_at_mosts;
  std::vector<Key> keys;
  std::vector<Rule> rules;            ///< none where no individual is named
  std::vector<owl::Automaton> paths;  ///< of the properties in rules that are not simple, in canonical roles
  std::vector<Clause> clauses;        ///< sorted, without doubles
  std::vector<ConceptFact> concept_facts;
  std::vector<RoleFact> role_facts;
  std::vector<DataFact> data_facts;
  std::vector<Equality> equalities;
  std::vector<IndividualId> apart;     ///< many that all differ from each other, of which `equalities` does not say it
  std::vector<ConceptId> queries;      ///< of each expression asked for: a concept whose instances are in it
  std::vector<ConceptId> complements;  ///< of each expression whose complement is asked for: one whose are not in it
  std::vector<Unused> open_rules;      ///< rules of which something is not known; a model that keeps them all is one
  std::vector<Unused> unused;          ///< ascending by axiom
  std::optional<owl::RoleBox> roles;   ///< of the properties
};

}  // namespace geminga::clauses

#endif
