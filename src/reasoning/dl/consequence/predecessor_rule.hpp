// The clauses that a context tells its predecessors, and the clauses of its successors that it resolves.
//
//  <u, v, f>    A1 and ... and Am -> L1 v ... v Ln in v    Gi -> Di v [Ai s] in u for each i
//  ---------------------------------------------------------------------------------------- Pred
//  G1 and ... and Gm -> D1 v ... v Dm v L1 s v ... v Ln s in u    [s: x to f(x), y to x; all Li are in Pr]
//
// v sends the clause once to each u that has said that all Ai may hold of its f(x). u resolves it with its own clauses.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_PREDECESSOR_RULE_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_PREDECESSOR_RULE_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/consequence/conclusions.hpp"
#include "reasoning/dl/consequence/context.hpp"
#include "reasoning/dl/consequence/effort.hpp"
#include "reasoning/dl/consequence/outbox.hpp"

namespace geminga::consequence {

/// The half of the rule in v. Of a context it reads the store, files keys in it, and changes the predecessors.
class PredecessorRule {
 public:
  PredecessorRule(Conclusions& conclusions, Outbox& outbox) : conclusions_(conclusions), outbox_(outbox) {}

  /// Notes that the things f(x) of `from` are in the context and that the hypotheses may hold of them. Assumes the
  /// new ones, L -> L, and sends the clauses that are known already.
  void add_edge(Context& context, Context& from, Term f, std::span<const Literal> hypotheses);
  /// Notes that the things f(x) of `from` are no more in the context.
  static void remove_edge(Predecessors& predecessors, const Context& from, Term f);
  /// Sends a processed clause or unit, all of whose literals are in Pr.
  void tell(Context& context, ClauseNumber clause);
  void tell(Context& context, Literal unit);
  /// Tells all predecessors that nothing is in the context.
  void tell_unsatisfiable(Context& context);

 private:
  void send(Context& context, const Edge& edge, std::span<const Literal> body, std::span<const Literal> head);

  Conclusions& conclusions_;
  Outbox& outbox_;
};

/// The half of the rule in u.
class SuccessorClauses {
 public:
  SuccessorClauses(Effort& effort, Conclusions& conclusions) : effort_(effort), conclusions_(conclusions) {}

  /// Resolves a clause of the successor f(x), and keeps it for later premises.
  void add(Context& context, Term f, std::span<const Literal> body, std::span<const Literal> head);
  /// Resolves the clause of this number in `waiting` with a new premise. Of the store it reads the clauses.
  void resolve(std::uint32_t number, Premise premise, const Pooled<WaitingClause>& waiting, ClauseStore& store);

 private:
  void join(const WaitingClause& clause, std::size_t at, ClauseStore& store);

  Effort& effort_;
  Conclusions& conclusions_;
  std::vector<Premise> premises_;  ///< of the match
};

}  // namespace geminga::consequence

#endif
