// A processed clause of a context, with the literal in which an inference resolves it.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_PREMISE_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_PREMISE_HPP

#include <limits>
#include <span>

#include "reasoning/dl/consequence/clause_store.hpp"

namespace geminga::consequence {

inline constexpr ClauseNumber no_clause = std::numeric_limits<ClauseNumber>::max();

/// The clause G -> D v [L]. If `clause` is no_clause, it is true -> L.
struct Premise {
  ClauseNumber clause = no_clause;
  Literal literal;
};

[[nodiscard]] inline std::span<const Literal> body_of(const ClauseStore& store, Premise premise) {
  return premise.clause == no_clause ? std::span<const Literal>() : store.body(premise.clause);
}
/// The head with L; empty for true -> L.
[[nodiscard]] inline std::span<const Literal> head_of(const ClauseStore& store, Premise premise) {
  return premise.clause == no_clause ? std::span<const Literal>() : store.head(premise.clause);
}

/// Whether a processed premise has not become redundant.
[[nodiscard]] inline bool is_active(const ClauseStore& store, Premise premise) {
  return premise.clause == no_clause || store.is_active(premise.clause);
}

/// Calls `use` with each processed clause in which the literal is maximal.
template <typename Use>
void for_each_premise(const ClauseStore& store, Literal literal, Use&& use) {
  const ClauseStore::Found found = store.look_up(literal);
  if (found.is_unit) return use(Premise{no_clause, literal});
  if (found.lists == nullptr) return;
  for (const ClauseNumber clause : found.lists->maximal) {
    if (store.is_active(clause)) use(Premise{clause, literal});
  }
}

}  // namespace geminga::consequence

#endif
