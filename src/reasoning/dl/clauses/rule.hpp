// Rules of SWRL that hold for named individuals (DL-safe: Motik, Sattler, Studer: Query Answering for OWL-DL with
// Rules, 2005).
//
//   body and not (a1 = b1) ... and not (ak = bk) -> head     is     body -> head or a1 = b1 ... or ak = bk
//
// A variable of an object stands for a named individual, one of a value for the value of a literal that an axiom holds
// or that a built-in works out.
#ifndef GEMINGA_REASONING_DL_CLAUSES_RULE_HPP
#define GEMINGA_REASONING_DL_CLAUSES_RULE_HPP

#include <cstdint>
#include <string_view>
#include <vector>

namespace geminga::clauses {

enum class RuleTermKind : std::uint8_t { variable, individual, literal };
struct RuleTerm {
  RuleTermKind kind = RuleTermKind::variable;
  std::uint32_t number = 0;  ///< of the variable from 0, of an IndividualId, or of the literal's term
};

enum class RuleAtomKind : std::uint8_t {
  named,       ///< the first is a named individual, which every object is
  concept_of,  ///< predicate: a ConceptId
  role,        ///< a PropertyId
  path,        ///< a property that is not simple: an index of ClauseSet::paths
  data_role,   ///< a DataPropertyId
  data_range,  ///< a DataRangeId
  equal,       ///< both are one individual
  unequal,     ///< they are not; heads only
  built_in,    ///< a BuiltIn
  unknown,     ///< nothing is known of it
};
struct RuleAtom {
  RuleAtomKind kind = RuleAtomKind::unknown;
  std::uint32_t predicate = 0;
  std::vector<RuleTerm> terms;
};

/// body -> one of `alternatives`, or all of `heads`. Without heads the body must be false.
struct Rule {
  std::vector<RuleAtom> body;
  std::vector<RuleAtom> heads;
  std::vector<RuleAtom> alternatives;  ///< equalities
  std::vector<bool> is_value;          ///< by variable
  std::uint32_t axiom = 0;             ///< its number in the source
  std::string_view problem;            ///< why some atom is unknown
};

/// Rules of more atoms, or whose atoms have more arguments together, are left out and named.
inline constexpr std::size_t max_rule_atoms = 256;
inline constexpr std::size_t max_rule_arguments = 1024;

}  // namespace geminga::clauses

#endif
