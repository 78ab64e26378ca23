// Rules of the calculus: clauses whose bodies have concepts of the centre and roles to its neighbours.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_RULE_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_RULE_HPP

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/consequence/rules/literal.hpp"

namespace geminga::consequence {

/// An atom of a rule; variables as in clauses::Clause.
struct RuleAtom {
  LiteralKind kind = LiteralKind::unary;  ///< unary A(first), outgoing R(x, first), incoming R(first, x), reflexive
  std::uint8_t first = 0;                 ///< R(first, first), or first = second
  std::uint8_t second = 0;
  std::uint32_t predicate = 0;
  friend auto operator<=>(const RuleAtom&, const RuleAtom&) = default;
};
using Atoms = std::vector<RuleAtom>;

[[nodiscard]] constexpr RuleAtom unary_atom(std::uint32_t predicate, std::uint8_t variable = 0) {
  return {LiteralKind::unary, variable, 0, predicate};
}
[[nodiscard]] inline bool is_role_atom(const RuleAtom& atom) {
  return atom.kind == LiteralKind::outgoing || atom.kind == LiteralKind::incoming;
}

struct Rule {
  Atoms body;
  Atoms head;
  std::uint8_t neighbours = 0;  ///< how many variables beside x
  bool is_ordered = false;      ///< its neighbours may be exchanged, so that it is enough to take them in one order
  friend auto operator<=>(const Rule&, const Rule&) = default;
};

/// The successors that a predicate "at least n R.B" creates: f1(x) ... fn(x), all different, with R(x, fi(x)) and
/// B(fi(x)).
struct Expansion {
  std::uint32_t first_function = 0;
  std::uint32_t count = 0;
  Atoms atoms;            ///< about variable 1, the successor
  bool is_value = false;  ///< the successors are values
};

/// The rules of an ontology and its predicates. Unary predicates are numbered: first named classes and nominals, which
/// may be asked for, then all other concepts, then one for each "at least" and "at most", data ranges, and new names.
/// Data properties are roles whose successors are values.
struct RuleSet {
  std::vector<Rule> rules;        ///< ascending, each once
  std::uint32_t query_count = 0;  ///< predicates below it may be asked for
  std::uint32_t predicate_count = 0;
  std::uint32_t role_count = 0;
  std::vector<std::uint32_t> predicate_of;         ///< of each ConceptId
  std::vector<clauses::ConceptId> query_concepts;  ///< of each predicate below query_count
  std::vector<std::uint32_t> nominal_of;           ///< of each IndividualId, the predicate {a}
  std::uint32_t first_marker = 0;                  ///< the predicate of the first expansion; the others follow
  std::vector<Expansion> expansions;
  /// By predicate: nominals, ranges of values that are not understood, and numbers that are too great. nominal_gap,
  /// range_gap and number_gap matter only if one of these may hold of a thing; see settled_contexts.hpp.
  std::vector<bool> is_open;
  std::vector<std::string> gaps;
};

}  // namespace geminga::consequence

#endif
