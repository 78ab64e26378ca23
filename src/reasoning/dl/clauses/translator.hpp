// From disjunctions of literals to clauses: the structural transformation, with names only where a clause needs one.
//
// The left side of an inclusion goes into the body if it can, so that Horn axioms give Horn clauses (Motik, Shearer,
// Horrocks 2009, section 4.1; this includes absorption). A name Q replaces a part that has no place in a clause: Q
// SubClassOf part if it stands in the head, part SubClassOf Q if it stands in the body. Equal parts have one name.
#ifndef GEMINGA_REASONING_DL_CLAUSES_TRANSLATOR_HPP
#define GEMINGA_REASONING_DL_CLAUSES_TRANSLATOR_HPP

#include <map>
#include <tuple>
#include <vector>

#include "reasoning/dl/clauses/literal.hpp"
#include "reasoning/dl/clauses/told_ends.hpp"
#include "reasoning/dl/clauses/vocabulary.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::clauses {

/// A literal that holds of a variable.
struct Placed {
  Literal literal;
  Variable at = centre;
};

/// A clause that is being written, and the literals that wait to be placed.
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
  Translator(Vocabulary& vocabulary, const owl::RoleBox& roles, ToldEnds& ends, ClauseSet& set, std::size_t max_clauses)
      : vocabulary_(vocabulary),
        source_(vocabulary.source()),
        roles_(roles),
        ends_(ends),
        set_(set),
        max_clauses_(max_clauses) {}

  /// Adds: everything is in one of these.
  void add(std::vector<Literal> disjunction);
  /// Adds the literals of a clause whose body and head have begun.
  void add(Draft draft);
  /// Adds a clause without its trivial atoms.
  void add_clause(Clause clause);
  /// A concept below the literal: a new name, or the literal's own concept.
  ConceptId below(Literal literal);
  /// A concept above the literal.
  ConceptId above(Literal literal);
  /// Adds: everything is in `literal`, or all its neighbours by the role are in the filler. A domain is the case of an
  /// empty filler, and a range is the domain of the inverse.
  void add_every(Role role, Literal filler, Literal literal);
  /// Adds the definitions of the names. To be called last.
  void define_names();

  /// R(x, y) of the canonical role. Its arguments are swapped for an inverse.
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
  /// Whether it puts something into the head. If not, its complement gets a name in the body.
  [[nodiscard]] bool is_positive(Literal literal);
  [[nodiscard]] bool is_positive_shape(const Shape& shape);
  Name& name_of(Literal literal);
  /// Puts a name in place of the literal.
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
  /// Whether each path of the role begins in the class because its first edge does, by what is told of single edges.
  [[nodiscard]] bool begins_in(Role role, Literal literal);
  /// Whether each path of the role ends in the class because its last edge does.
  [[nodiscard]] bool ends_in(Role role, Literal literal);
  /// The concept of the first state of the automaton for `every role.filler`, and whether it goes into the head.
  std::pair<ConceptId, bool> path(Role role, Literal filler);
  void add_moves(const owl::Automaton& automaton, const std::vector<ConceptId>& states, Literal filler,
                 bool is_forward);

  Vocabulary& vocabulary_;
  const owl::Ontology& source_;
  const owl::RoleBox& roles_;
  ToldEnds& ends_;
  ClauseSet& set_;
  std::size_t max_clauses_;
  std::map<Key, Name> names_;
  std::map<Key, bool> is_positive_;
  std::map<std::tuple<Role, Key, bool>, ConceptId> paths_;
  std::vector<Definition> definitions_;
};

}  // namespace geminga::clauses

#endif
