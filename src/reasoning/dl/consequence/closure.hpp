// Derives what follows from clauses: all subsumers of each concept that is asked for.
//
// The consequence-based calculus of Bate, Motik, Cuenca Grau, Tena Cucala, Simancik, Horrocks: Consequence-Based
// Reasoning for Description Logics with Disjunctions and Number Restrictions (JAIR 2018). On Horn clauses every head
// has at most one literal, and it is the Horn-SHIQ calculus of Kazakov (IJCAI 2009).
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_CLOSURE_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_CLOSURE_HPP

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/consequence/rules/gaps.hpp"

namespace geminga::owl {
class Ontology;
}

namespace geminga::consequence {

struct Options {
  unsigned threads = 1;
  /// Whether facts count, too. Without them is_consistent is about the other axioms, and there is no gap
  /// about facts alone (gaps.hpp).
  bool facts = true;
  /// The most derived clauses of all contexts together. Long ones count several times, and failed attempts a little.
  /// Beyond it the closure is incomplete. A million takes at most some hundred megabytes.
  std::size_t clauses = 5'000'000;
  /// The most conclusions with alternatives (more than one literal in the head) in one context. Beyond it the context
  /// keeps only what has no alternatives, and the closure has alternative_gap. Does not bound Horn clauses.
  std::uint32_t alternatives = std::numeric_limits<std::uint32_t>::max();
  /// A budget that other work shares. Without it only the limit of clauses holds. When it is spent the closure is
  /// incomplete. Borrowed.
  base::Budget* budget = nullptr;
};

/// The consequences of the clauses. Always sound. Complete if `gaps` is empty.
struct Closure {
  bool is_consistent = true;  ///< false: an individual of the facts cannot exist
  /// For each concept that was asked for, in that order: the named classes and nominals above it, ascending, including
  /// itself; {nothing} if it is unsatisfiable.
  std::vector<std::vector<clauses::ConceptId>> subsumers;
  /// Why something may be missing, one line each, such as "values with owl:oneOf"; sorted, without doubles.
  std::vector<std::string> gaps;
  /// For each concept that was asked for, whether it is settled: no gap matters to it, and all its subsumers are known
  /// if the ontology is consistent.
  std::vector<bool> is_settled;
  /// For each concept that was asked for, whether it is settled without alternatives: if the ontology is consistent, it
  /// has a model with an instance that is in exactly the named classes among its subsumers.
  std::vector<bool> is_plain;
  bool is_cut_off = false;  ///< a limit was reached
  std::size_t contexts = 0;
  std::size_t derived = 0;  ///< clauses
};

/// The result depends neither on the order of clauses nor on the number of threads, except for the counts and for a
/// closure that was cut off. Builds only what the concepts asked for lead to and, with `facts`, the individuals.
[[nodiscard]] Closure saturate(const owl::Ontology& source, const clauses::ClauseSet& clauses,
                               std::span<const clauses::ConceptId> wanted, const Options& options = {});

/// The answer to one question.
enum class Derived : std::uint8_t {
  yes,      ///< it follows
  no,       ///< it does not follow from the clauses
  cut_off,  ///< it was not derived before a limit was reached
  open,     ///< it was not derived, and the closure has gaps at any limit, or `super` is no name
};

/// Whether `super` follows for the one concept that the clauses have a query of, which it also does where that can have
/// no instance. A no takes all that follows into account, so that it requires clauses with a complement of `super`.
[[nodiscard]] Derived derives(const owl::Ontology& source, const clauses::ClauseSet& clauses, owl::TermId super,
                              const Options& options);

}  // namespace geminga::consequence

#endif
