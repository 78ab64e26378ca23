// Derives what follows from clauses: for each concept that is asked for, everything that subsumes it.
//
// The consequence-based calculus of Bate, Motik, Cuenca Grau, Tena Cucala, Simancik, Horrocks: Consequence-Based
// Reasoning for Description Logics with Disjunctions and Number Restrictions (JAIR 2018). On Horn clauses every head
// has at most one literal, and it is the Horn-SHIQ calculus of Kazakov (IJCAI 2009).
#ifndef GEMINGA_CONSEQUENCE_CLOSURE_HPP
#define GEMINGA_CONSEQUENCE_CLOSURE_HPP

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "clauses/clause.hpp"

namespace geminga::consequence {

struct Options {
  unsigned threads = 1;
  std::size_t clauses = 20'000'000;  ///< derived ones, of all contexts together; beyond it the closure is incomplete
};

/// What follows. Always sound; complete where `gaps` is empty.
struct Closure {
  bool is_consistent = true;  ///< false: an individual of the facts cannot exist
  /// Of each concept that was asked for, in that order: the named classes and nominals above it, ascending, itself
  /// included; {nothing} where it can have no instance.
  std::vector<std::vector<clauses::ConceptId>> subsumers;
  /// Why something may be missing, one line each, e.g. "values with owl:oneOf"; sorted, without doubles.
  std::vector<std::string> gaps;
  std::size_t contexts = 0;
  std::size_t derived = 0;  ///< clauses
};

/// The result depends neither on the order of clauses nor on the number of threads.
[[nodiscard]] Closure saturate(const el::OntologySource& source, const clauses::ClauseSet& clauses,
                               std::span<const clauses::ConceptId> wanted, const Options& options = {});

}  // namespace geminga::consequence

#endif
