// The clauses of axioms about classes, and keys.
#ifndef GEMINGA_REASONING_DL_CLAUSES_CLASS_CLAUSES_HPP
#define GEMINGA_REASONING_DL_CLAUSES_CLASS_CLAUSES_HPP

#include <span>
#include <string_view>
#include <vector>

#include "reasoning/dl/clauses/allowed.hpp"
#include "reasoning/dl/clauses/ordered_axiom.hpp"
#include "reasoning/dl/clauses/translator.hpp"

namespace geminga::clauses {

class ClassClauses {
 public:
  ClassClauses(Vocabulary& vocabulary, Allowed& allowed, Translator& translator, ClauseSet& set)
      : vocabulary_(vocabulary), allowed_(allowed), translator_(translator), set_(set) {}

  /// Why the axiom has no clauses, or not all. Empty if it has, or has no class expression.
  [[nodiscard]] std::string_view problem(const OrderedAxiom& axiom);
  /// Adds the clauses of an axiom about classes. Parts that are not allowed are left out.
  void add(const OrderedAxiom& axiom);

 private:
  void add_inclusion(owl::TermId sub, owl::TermId super);
  /// Adds the disjunction, unless a part of it is not allowed.
  void add_disjunction(std::vector<Literal> disjunction);
  void add_disjoint(std::span<const owl::TermId> members);
  void add_disjoint_pairs(std::span<const owl::TermId> members);
  void add_disjoint_groups(std::vector<ConceptId> groups);
  void add_key(const OrderedAxiom& axiom);

  Vocabulary& vocabulary_;
  Allowed& allowed_;
  Translator& translator_;
  ClauseSet& set_;
};

}  // namespace geminga::clauses

#endif
