// The work of one thread on one context at a time: it reads messages, and processes one new clause after the other.
//
// The rules are those of Bate et al., table 2. Each stands in logic notation beside its code. Legend: u v contexts, G
// bodies (conjunctions), D heads (disjunctions), A an atom, L a literal, O the ontology's rules, f a function symbol.
// In G -> D v [L] the brackets say that L is maximal in that head; core(v) is the core. Su and Pr are the literals that
// are passed to successors and predecessors. <u, v, f> says that the things f(x) of u are in v.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_WORKER_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_WORKER_HPP

#include "reasoning/dl/consequence/conclusions.hpp"
#include "reasoning/dl/consequence/context.hpp"
#include "reasoning/dl/consequence/effort.hpp"
#include "reasoning/dl/consequence/filing.hpp"
#include "reasoning/dl/consequence/hyperresolution.hpp"
#include "reasoning/dl/consequence/nominal_rules.hpp"
#include "reasoning/dl/consequence/outbox.hpp"
#include "reasoning/dl/consequence/paramodulation.hpp"
#include "reasoning/dl/consequence/predecessor_rule.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"
#include "reasoning/dl/consequence/successor_rule.hpp"

namespace geminga::consequence {

/// Takes each clause to the rules. Every rule is a class that knows the conclusions or the outbox and no other rule.
class Worker {
 public:
  Worker(const Rules& rules, SharedEffort& shared, const Outbox& outbox);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Works until the context has neither messages nor new clauses. The context must be scheduled.
  void work(Context& context);

 private:
  void receive(Context& context);
  void receive(Context& context, const Message& message, std::span<const Literal> body, std::span<const Literal> head);
  void start(const Context& context, ClauseStore& store);
  void note_existence(Context& context);
  void saturate(Context& context);
  void process_unit(Context& context, Literal literal);
  void process_clause(Context& context, ClauseNumber clause);
  void process(Context& context, Premise premise);
  void match(Context& context, Premise premise);
  void file_conclusions(Context& context);

  const Rules& rules_;
  SharedEffort& shared_;
  Effort effort_;
  Outbox outbox_;
  Conclusions conclusions_;
  Filing filing_;
  Hyperresolution hyperresolution_;
  Paramodulation paramodulation_;
  SuccessorRule successor_rule_;
  PredecessorRule predecessor_rule_;
  SuccessorClauses successor_clauses_;
  NominalRules nominal_rules_;
  // The messages that were taken out of a mailbox.
  Pooled<Message> messages_;
  Pooled<Literal> message_literals_;
};

}  // namespace geminga::consequence

#endif
