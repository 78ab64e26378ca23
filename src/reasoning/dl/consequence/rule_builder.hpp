// Brings clauses into the form of the calculus, in which a body has concepts of the centre and roles to its neighbours.
//
// Only the neighbour's own context knows its concepts, so a body's atoms about a neighbour become a rule there (Bate et
// al., table 1). There are three ways, and the first that applies is taken:
//   B(y), R(x,y) -> H(x,y)          becomes  B(x), R(y,x) -> H(y,x)                    the neighbour is made the centre
//   A(x), B(y), R(x,y) -> H(x)      becomes  B(x), R(y,x) -> P(y)   A(x), P(x) -> H(x)         P names "some R.B"
//   A(x), B(y), R(x,y) -> H(x,y)    becomes  B(x), R(y,x) -> R'(y,x)   A(x), R'(x,y) -> H(x,y)  R' names "R into B"
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULE_BUILDER_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULE_BUILDER_HPP

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/consequence/literal.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::consequence {

/// An atom of a rule; variables as in clauses::Clause.
struct RuleAtom {
  LiteralKind kind = LiteralKind::unary;  ///< unary A(first), outgoing R(x, first), incoming R(first, x), reflexive
  std::uint8_t first = 0;                 ///< R(first, first), or first = second
  std::uint8_t second = 0;
  std::uint32_t predicate = 0;
  friend auto operator<=>(const RuleAtom&, const RuleAtom&) = default;
};

[[nodiscard]] inline bool is_role_atom(const RuleAtom& atom) {
  return atom.kind == LiteralKind::outgoing || atom.kind == LiteralKind::incoming;
}

/// A clause of the ontology whose body has concepts of the centre and roles to its neighbours.
struct Rule {
  std::vector<RuleAtom> body;
  std::vector<RuleAtom> head;
  std::uint8_t neighbours = 0;  ///< how many variables beside x
  bool is_ordered = false;      ///< its neighbours may be exchanged, so that it is enough to take them in one order
  friend auto operator<=>(const Rule&, const Rule&) = default;
};

/// What a predicate "at least n R.B" creates: f1(x) ... fn(x), all different, with R(x, fi(x)) and B(fi(x)).
struct Expansion {
  std::uint32_t first_function = 0;
  std::uint32_t count = 0;
  std::vector<RuleAtom> atoms;  ///< about variable 1, the successor
  bool is_value = false;        ///< the successors are values
};

/// The predicates of the calculus. Unary ones are numbered: first named classes and nominals, which may be asked for,
/// then all other concepts, then one for each "at least" and "at most", data ranges, and names that RuleBuilder makes.
/// Data properties are roles whose successors are values.
struct RuleSet {
  std::vector<Rule> rules;
  std::uint32_t query_count = 0;  ///< predicates below it are what may be asked for
  std::uint32_t predicate_count = 0;
  std::uint32_t role_count = 0;
  std::vector<std::uint32_t> predicate_of;         ///< of each ConceptId
  std::vector<clauses::ConceptId> query_concepts;  ///< of each predicate below query_count
  std::vector<std::uint32_t> nominal_of;           ///< of each IndividualId, the predicate {a}
  std::uint32_t first_marker = 0;                  ///< predicates from here on have an expansion, while there are any
  std::vector<Expansion> expansions;
  /// By predicate: nominals, and ranges of values that are not understood. nominal_gap and range_gap matter only if one
  /// of these may hold of a thing; see settled.hpp.
  std::vector<bool> is_open;
  std::vector<std::string> gaps;
};

/// At-mosts with a greater number are left out and named, because their rules would have so many variables.
inline constexpr std::uint32_t max_at_most = 64;

class RuleBuilder {
 public:
  /// `with_facts`: facts about individuals become rules, too.
  RuleBuilder(const owl::Ontology& source, const clauses::ClauseSet& clauses, bool with_facts);
  /// Makes rules of the clauses and of the facts. To be called once.
  [[nodiscard]] RuleSet run();

 private:
  using Atoms = std::vector<RuleAtom>;

  void number_predicates();
  void make_expansions();
  [[nodiscard]] std::uint32_t add_expansion(std::uint32_t count, Atoms atoms);
  void add_at_most(std::uint32_t marker, std::uint32_t count, RuleAtom role, std::uint32_t filler);
  void add_clause(const clauses::Clause& clause);
  /// Adds a rule whose body may speak of neighbours' concepts.
  void add(Atoms body, Atoms head);
  void add_rule(Atoms body, Atoms head);
  /// Replaces the centre's concepts in a long body by names for some of them.
  void shorten(Atoms& body);
  [[nodiscard]] std::uint32_t name_for(const Atoms& about_neighbour, bool is_role);
  /// Appends what the atom is in this calculus. False: the atom is true in a body or false in a head.
  [[nodiscard]] bool convert(const clauses::Atom& atom, bool is_head, Atoms& atoms, bool& is_redundant) const;
  [[nodiscard]] RuleAtom concept_atom(clauses::ConceptId of, std::uint8_t variable) const;

  // facts.cpp
  void gather_facts();
  void add_facts();
  void add_values();
  void find_gaps();

  const owl::Ontology& source_;
  const clauses::ClauseSet& clauses_;
  bool with_facts_;
  RuleSet result_;
  std::vector<std::uint32_t> range_predicate_;        ///< of each DataRangeId, then of the values of data facts
  std::map<owl::TermId, std::uint32_t> fact_values_;  ///< the position among them
  /// What is known between two individuals. Variable 1 is a neighbour of the first.
  std::map<std::pair<std::uint32_t, std::uint32_t>, Atoms> links_;
  std::uint32_t at_most_base_ = 0;
  std::uint32_t data_role_base_ = 0;
  std::uint32_t functions_ = 0;
  std::uint32_t thing_ = 0;
  std::uint32_t nothing_ = 0;
  bool is_finite_ = false;              ///< some data range is
  std::vector<std::uint32_t> unclear_;  ///< predicates of ranges that are not understood
  std::map<std::pair<Atoms, bool>, std::uint32_t> names_;
};

}  // namespace geminga::consequence

#endif
