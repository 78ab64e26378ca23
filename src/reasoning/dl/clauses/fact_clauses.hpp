// The facts of a clause set, and the clauses of negative facts.
#ifndef GEMINGA_REASONING_DL_CLAUSES_FACT_CLAUSES_HPP
#define GEMINGA_REASONING_DL_CLAUSES_FACT_CLAUSES_HPP

#include <cstddef>
#include <span>

#include "reasoning/dl/clauses/ordered_axiom.hpp"
#include "reasoning/dl/clauses/translator.hpp"

namespace geminga::clauses {

/// A list of more different individuals may be ClauseSet::apart, which needs no equality for each pair.
inline constexpr std::size_t max_paired_individuals = 64;

class FactClauses {
 public:
  /// With more equalities the facts are not complete, and the set is refused. Borrows the axioms.
  FactClauses(Vocabulary& vocabulary, Translator& translator, ClauseSet& set, std::size_t max_equalities,
              std::span<const OrderedAxiom> axioms);

  /// Adds what a fact states. Other axioms state nothing here.
  void add(const OrderedAxiom& axiom);

 private:
  void assert_fact(Literal literal, IndividualId individual);
  void add_different(const OrderedAxiom& axiom);

  Vocabulary& vocabulary_;
  Translator& translator_;
  ClauseSet& set_;
  std::size_t max_equalities_;
  const OrderedAxiom* longest_ = nullptr;  ///< of the lists of many different individuals
};

}  // namespace geminga::clauses

#endif
