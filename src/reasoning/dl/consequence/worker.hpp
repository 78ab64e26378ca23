// Works on one context at a time: takes a new clause and applies every rule to it and the processed clauses.
//
// The rules are those of Bate et al., table 2. Each stands in logic notation beside its code. Legend: u v contexts, G
// bodies (conjunctions), D heads (disjunctions), A an atom, L a literal, O the ontology's rules, f a function symbol.
// In G -> D v [L] the brackets say that L is maximal in that head; core(v) is the core. Su and Pr are the literals that
// are passed to successors and predecessors. <u, v, f> says that the things f(x) of u are in v.
//
// Conclusions are collected while a rule looks through the store, and filed afterwards.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_WORKER_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_WORKER_HPP

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "reasoning/dl/consequence/context.hpp"
#include "reasoning/dl/consequence/rules.hpp"

namespace geminga::consequence {

class Saturation;

class Worker {
 public:
  Worker(Saturation& saturation, unsigned number);
  /// Works until the context has neither messages nor new clauses. The context must be scheduled.
  void work(Context& context);

 private:
  static constexpr std::size_t attempts_at_once = 4096;
  /// Literals of conclusions that wait to be filed (64 MiB). A single step with more of them cannot end in time anyway.
  static constexpr std::size_t max_waiting_literals = std::size_t{1} << 24;
  /// A clause counts once for each of so many literals, so that the count bounds the memory.
  static constexpr std::size_t literals_per_clause = 8;
  /// Comparing a new clause with this many others takes as long as an attempt.
  static constexpr std::size_t compared_per_attempt = 8;
  static constexpr ClauseNumber no_clause = std::numeric_limits<ClauseNumber>::max();
  /// The clause G -> D v [L]. If `clause` is no_clause, it is true -> L.
  struct Premise {
    ClauseNumber clause = no_clause;
    Literal literal;
  };

  // worker.cpp: the queue of one context, and redundancy.
  void receive();
  void saturate_locally();
  void activate_unit(Literal literal);
  void activate_clause(ClauseNumber clause);
  void activate(Premise premise);
  [[nodiscard]] std::size_t maximal_count(std::span<const Literal> head) const;
  void start();
  void become_unsatisfiable();
  /// Files body -> head unless it is redundant. Both may be in any order, and are used as working space.
  void add(std::vector<Literal>& body, std::vector<Literal>& head);
  void add_unit(Literal literal);
  void note_open(Literal literal) {
    if (literal.kind() == LiteralKind::unary && rules_.is_open(literal.predicate())) context_->has_open = true;
  }
  /// Counts a conclusion with alternatives. False: the context keeps no more of these.
  [[nodiscard]] bool may_have_alternatives();
  void cut();
  [[nodiscard]] bool simplify_head(std::vector<Literal>& head);
  void file_conclusions();

  // conclusions.cpp: from premises to conclusions.
  [[nodiscard]] std::span<const Literal> body_of(Premise premise) const;
  [[nodiscard]] std::span<const Literal> head_of(Premise premise) const;
  void begin_conclusion();
  void add_side(Premise premise);
  void end_conclusion(std::span<const Literal> head);
  /// Calls `use` with each processed clause in which the literal is maximal.
  template <typename Use>
  void for_each_premise(Literal literal, Use&& use) const {
    const ClauseStore& store = context_->store;
    const ClauseStore::Found found = store.look_up(literal);
    if (found.is_unit) return use(Premise{no_clause, literal});
    if (found.lists == nullptr) return;
    for (const ClauseNumber clause : found.lists->maximal) {
      if (store.is_active(clause)) use(Premise{clause, literal});
    }
  }
  /// Concludes G -> D v L' from the premise G -> D v [L].
  void conclude(Premise premise, Literal instead);
  [[nodiscard]] Literal replaced(Literal literal, Term by) const;

  // hyper.cpp
  void hyper(Premise premise, const Occurrence& occurrence, Term neighbour);
  [[nodiscard]] bool may_hold(const RuleAtom& atom, Term term) const;
  void count_attempt() { count_attempts(1); }
  void count_attempts(std::size_t attempts);
  void join(const Rule& rule);
  void join_with(const Rule& rule, std::size_t atom, Literal literal);
  void conclude_rule(const Rule& rule);
  void expand(Premise premise, const Expansion& expansion);
  [[nodiscard]] bool may_bind(const Rule& rule, std::uint8_t variable, Term term) const;

  // equality.cpp
  [[nodiscard]] bool is_replaced(Term f) const;
  void paramodulate(Premise equation, Premise into);
  void apply_equality(Premise premise);
  void apply_equalities_to(Premise premise, const Successor& successor);
  void factor(Premise premise);

  // successors.cpp
  [[nodiscard]] Successor& successor_of(Term f);
  void mark_changed(Successor& successor);
  /// The successor that the literal is about. Valid until there is a new successor.
  const Successor& note_about_successor(Premise premise);
  void apply_succ(Successor& successor);

  // predecessors.cpp
  void receive_edge(const Message& message, std::span<const Literal> hypotheses);
  void receive_clause(const Message& message, std::span<const Literal> body, std::span<const Literal> head);
  void join_foreign(const ForeignClause& clause, std::size_t at);
  void resolve_foreign(std::uint32_t foreign, Premise premise);
  void tell_predecessors(ClauseNumber clause);
  void tell_predecessors(Literal unit);
  void tell(const Edge& edge, std::span<const Literal> body, std::span<const Literal> head);

  // nominals.cpp
  void apply_nominals(Literal unit);
  void apply_nominal(Literal unit);
  [[nodiscard]] bool is_context_of(std::uint32_t nominal) const;
  void tell_nominal(std::uint32_t nominal, Literal unit);
  void tell_nominal_all(std::uint32_t nominal);
  void receive_fact(Literal fact);
  void receive_inheritor(Context* inheritor);
  void receive_existence();
  void tell_existence(Successor& successor);

  Saturation& saturation_;
  const Rules& rules_;
  unsigned number_;
  Context* context_ = nullptr;
  std::size_t derived_ = 0;

  // Working space that is kept between calls.
  Pooled<Message> messages_;
  Pooled<Literal> message_literals_;
  std::vector<Premise> premises_;
  std::vector<Term> binding_;          ///< of each variable of a rule; unbound where none
  std::vector<std::uint8_t> is_done_;  ///< of each atom of a body
  std::vector<Literal> conclusion_body_;
  std::vector<Literal> conclusion_head_;
  std::vector<Literal> units_;         ///< conclusions that are units
  std::vector<Literal> literals_;      ///< of other conclusions
  std::vector<std::uint32_t> counts_;  ///< of each of them: of body, of head
  std::size_t attempts_ = 0;           ///< to match bodies, not yet counted by the saturation
  std::size_t compared_ = 0;           ///< clauses, not yet counted as attempts
  bool is_stopped_ = false;            ///< too much was derived: whatever is under way ends
  std::vector<Literal> body_;
  std::vector<Literal> head_;
  bool is_false_derived_ = false;
};

}  // namespace geminga::consequence

#endif
