// One context: the clauses about all things of which its core holds, with its successors and predecessors.
//
// One thread at a time works on a context. Others only put messages into its mailbox.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_CONTEXT_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_CONTEXT_HPP

#include <cstdint>
#include <limits>

#include "reasoning/dl/consequence/clause_store.hpp"
#include "reasoning/dl/consequence/mailbox.hpp"
#include "reasoning/dl/consequence/successors.hpp"

namespace geminga::consequence {

/// The key of a context. A private context belongs to one function symbol, whose things are not certain to exist.
struct ContextKey {
  Pooled<Literal> core;  ///< ascending
  std::uint32_t function = std::numeric_limits<std::uint32_t>::max();
  bool is_value = false;  ///< its members are values: what is said of every thing is not said of them
  friend bool operator==(const ContextKey&, const ContextKey&) = default;
};

/// The clauses that are filed and not processed. Units come first, because they make others redundant.
struct ClauseQueue {
  Pooled<Literal> units;
  Pooled<ClauseNumber> clauses;
};

/// The things f(x) of the things x of `from` are in this context, as far as the hypotheses hold of them.
struct Edge {
  Context* from = nullptr;
  Term f{};
  bool is_live = true;
  Pooled<Literal> hypotheses;  ///< ascending
};

/// The contexts that have things in this one, and the clauses that all of them are told.
struct Predecessors {
  Pooled<Edge> edges;
  Pooled<ClauseNumber> clauses_for_all;  ///< clauses with an empty body
  Pooled<Literal> units_for_all;
};

/// A clause of a successor that waits for its body to hold, in the names of the context that has it.
struct WaitingClause {
  Pooled<Literal> body;
  Pooled<Literal> head;
};

/// The nominals that x is, and the facts that are passed between their contexts (nominal_rules.hpp).
struct NominalLinks {
  Pooled<std::uint32_t> nominals;  ///< that x is
  Pooled<Literal> facts;           ///< that were told
  Pooled<Context*> inheritors;     ///< contexts whose things are the nominal that this one is about
};

struct Context {
  std::uint32_t number = 0;
  ContextKey key;
  /// Whether its units are asked for; see Rules::is_query().
  bool answers_queries = false;
  bool is_unsatisfiable = false;
  bool has_open = false;     ///< something open is in the head of a clause, see RuleSet::is_open
  bool is_nonempty = false;  ///< something certainly is in it; see nominal_rules.hpp
  ClauseStore store;
  ClauseQueue queue;
  Successors successors;
  Predecessors predecessors;
  Pooled<WaitingClause> waiting;
  NominalLinks nominal_links;
  Mailbox mailbox;
};

}  // namespace geminga::consequence

#endif
