// From disjunctions of literals to clauses: the structural transformation, with names only where a clause needs one.
//
// What stands on the left of an inclusion goes into the body where it can (Motik, Shearer, Horrocks 2009, section 4.1;
// absorption comes of itself), so that Horn axioms give Horn clauses. A part that has no place in a clause is replaced
// by a name Q: Q SubClassOf part where it stands in the head, part SubClassOf Q where it stands in the body. Equal
// parts have one name.
#ifndef GEMINGA_REASONING_DL_CLAUSES_TRANSLATOR_HPP
#define GEMINGA_REASONING_DL_CLAUSES_TRANSLATOR_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "reasoning/dl/clauses/literal.hpp"
#include "reasoning/dl/clauses/vocabulary.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::clauses {

/// A literal that holds of a variable.
struct Placed {
  Literal literal;
  Variable at = centre;
};

/// A clause that is being written: what it has so far, or one of the literals that wait.
struct Draft {
  Clause clause;
  std::vector<Placed> waiting;
  std::vector<Placed> conjunctions;
  std::vector<Literal> quantified;
  std::size_t copies = 1;  ///< clauses that come of the same inclusion
  std::size_t spread = 0;  ///< operands of unions that were placed
  Variable variables = 1;
  bool is_true = false;
  bool is_binary = false;  ///< it speaks of a neighbour from the outset
};

class Translator {
 public:
  Translator(Vocabulary& vocabulary, const owl::RoleBox& roles, ClauseSet& set, std::size_t max_clauses)
      : vocabulary_(vocabulary), source_(vocabulary.source()), roles_(roles), set_(set), max_clauses_(max_clauses) {}

  /// Everything is in one of these.
  void add(std::vector<Literal> disjunction);
  /// The same beside the body and head of a clause.
  void add(Draft draft);
  /// As it is, but for atoms that say nothing.
  void add_clause(Clause clause);
  /// A concept below the literal: a name, or the atom itself.
  ConceptId below(Literal literal);
  /// A concept above the literal.
  ConceptId above(Literal literal);
  /// Everything is in `literal` or has neighbours by the role in the filler only. A domain is this with an empty
  /// filler, a range the domain of the inverse.
  void add_every(Role role, Literal filler, Literal literal);
  /// Defines the names that were given. To be called last.
  void define_names();

  /// R(x, y) of the canonical role, its arguments turned where it is an inverse.
  [[nodiscard]] Atom role_atom(Role role, Variable from, Variable to) const;
  [[nodiscard]] Role role(owl::TermId property) { return roles_.canonical(vocabulary_.role(property)); }
  [[nodiscard]] bool is_full() const { return set_.clauses.size() > max_clauses_; }

 private:
  using Key = std::tuple<owl::ContentHashes::Hash, bool, Part>;
  struct Name {
    ConceptId id{};
    Literal literal;
    bool is_defined_below = false;  ///< name SubClassOf literal is asked for
    bool is_defined_above = false;
  };
  struct Definition {
    ConceptId id{};
    Literal literal;
    bool is_above = false;
  };

  /// Q -> L, or L -> Q.
  static Draft clause_of(const Definition& definition);
  [[nodiscard]] Key key_of(Literal literal) const;
  /// Whether it puts something into the head: else its complement is named, in the body.
  [[nodiscard]] bool is_positive(Literal literal);
  [[nodiscard]] bool is_positive_shape(const Shape& shape);
  Name& name_of(Literal literal);
  /// Stands for the literal in a clause by its name.
  void put_name(Draft& draft, Placed placed);
  void put_atom(Draft& draft, ConceptId of, Variable at, bool is_negated) const;
  void spread(Draft& draft);
  void place(Draft& draft, Placed placed);
  void place_at_centre(Draft& draft, Literal literal, Shape&& shape);
  void place_at_least(Draft& draft, const Shape& shape);
  void place_every(Draft& draft, Role role, Literal filler);
  void place_at_most(Draft& draft, const Shape& shape);
  void place_data(Draft& draft, const Shape& shape);
  void split(Draft draft);
  void finish(Draft draft);
  /// The concept of the first state of a role's automaton with `every role.filler`, and whether it goes into the head.
  std::pair<ConceptId, bool> path(Role role, Literal filler);
  void add_moves(const owl::Automaton& automaton, const std::vector<ConceptId>& states, Literal filler,
                 bool is_forward);

  Vocabulary& vocabulary_;
  const owl::Ontology& source_;
  const owl::RoleBox& roles_;
  ClauseSet& set_;
  std::size_t max_clauses_;
  std::map<Key, Name> names_;
  std::map<Key, bool> is_positive_;
  std::map<std::tuple<Role, Key, bool>, ConceptId> paths_;
  std::vector<Definition> definitions_;
};

}  // namespace geminga::clauses

#endif
