// The facts of a clause set, and the clauses of negative facts.
#ifndef GEMINGA_REASONING_DL_CLAUSES_FACT_CLAUSES_HPP
#define GEMINGA_REASONING_DL_CLAUSES_FACT_CLAUSES_HPP

#include <cstddef>

#include "reasoning/dl/clauses/ordered_axiom.hpp"
#include "reasoning/dl/clauses/translator.hpp"

namespace geminga::clauses {

class FactClauses {
 public:
  /// With more equalities the facts are not complete, and the set is refused.
  FactClauses(Vocabulary& vocabulary, Translator& translator, ClauseSet& set, std::size_t max_equalities)
      : vocabulary_(vocabulary), translator_(translator), set_(set), max_equalities_(max_equalities) {}

  /// Adds what a fact states. Other axioms state nothing here.
  void add(const OrderedAxiom& axiom);

 private:
  void assert_fact(Literal literal, IndividualId individual);

  Vocabulary& vocabulary_;
  Translator& translator_;
  ClauseSet& set_;
  std::size_t max_equalities_;
};

}  // namespace geminga::clauses

#endif
