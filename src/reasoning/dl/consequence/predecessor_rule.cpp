#include "reasoning/dl/consequence/predecessor_rule.hpp"

#include <algorithm>
#include <utility>

namespace geminga::consequence {

void PredecessorRule::add_edge(Context& context, Context& from, Term f, std::span<const Literal> hypotheses) {
  if (context.is_unsatisfiable) return outbox_.send(from, MessageKind::clause, &context, f);
  ClauseStore& store = context.store;
  Predecessors& predecessors = context.predecessors;
  std::uint32_t number = store.number_of(edge_key(f, from.number));
  if (number == 0 || !predecessors.edges[number - 1].is_live) {
    predecessors.edges.push_back({&from, f, true, {}});
    number = static_cast<std::uint32_t>(predecessors.edges.size());
    store.number_of(edge_key(f, from.number)) = number;
    const Edge& edge = predecessors.edges.back();
    for (const Literal& unit : predecessors.units_for_all) send(context, edge, {}, std::span(&unit, 1));
    for (const ClauseNumber clause : predecessors.clauses_for_all) {
      if (store.is_live(clause)) send(context, edge, {}, store.head(clause));
    }
  }
  Edge& edge = predecessors.edges[number - 1];
  for (const Literal hypothesis : hypotheses) {
    const auto place = std::ranges::lower_bound(edge.hypotheses, hypothesis);
    if (place != edge.hypotheses.end() && *place == hypothesis) continue;
    edge.hypotheses.insert(place, hypothesis);
    if (store.set(in_body(hypothesis), ClauseStore::assumed)) {
      conclusions_.begin();
      conclusions_.add_body(std::span(&hypothesis, 1));
      conclusions_.finish(store, std::span(&hypothesis, 1));
    }
    auto& lists = store.lists_of(in_body(hypothesis));
    lists.waiting.push_back(number - 1);
    for (const ClauseNumber clause : lists.maximal) {
      if (!store.is_live(clause)) continue;
      if (!std::ranges::includes(edge.hypotheses, store.body(clause))) continue;
      send(context, edge, store.body(clause), store.head(clause));
    }
  }
}

void PredecessorRule::remove_edge(Predecessors& predecessors, const Context& from, Term f) {
  for (Edge& edge : predecessors.edges) {
    if (edge.from == &from && edge.f == f) edge.is_live = false;
  }
}

void PredecessorRule::send(Context& context, const Edge& edge, std::span<const Literal> body,
                           std::span<const Literal> head) {
  outbox_.send(*edge.from, MessageKind::clause, &context, edge.f, body, head);
}

void PredecessorRule::tell(Context& context, Literal unit) {
  context.predecessors.units_for_all.push_back(unit);
  for (const Edge& edge : context.predecessors.edges) {
    if (edge.is_live) send(context, edge, {}, std::span(&unit, 1));
  }
}

void PredecessorRule::tell(Context& context, ClauseNumber clause) {
  ClauseStore& store = context.store;
  const auto body = store.body(clause);
  const auto head = store.head(clause);
  // A tautology is of no use there.
  if (std::ranges::any_of(body, [&](Literal literal) { return std::ranges::find(head, literal) != head.end(); }))
    return;
  if (body.empty()) {
    context.predecessors.clauses_for_all.push_back(clause);
    for (const Edge& edge : context.predecessors.edges) {
      if (edge.is_live) send(context, edge, body, head);
    }
    return;
  }
  for (const Literal literal : body) store.lists_of(in_body(literal)).maximal.push_back(clause);
  for (const std::uint32_t number : store.lists_of(in_body(body[0])).waiting) {
    const Edge& edge = context.predecessors.edges[number];
    if (edge.is_live && std::ranges::includes(edge.hypotheses, body)) send(context, edge, body, head);
  }
}

void PredecessorRule::tell_unsatisfiable(Context& context) {
  for (const Edge& edge : context.predecessors.edges) {
    if (edge.is_live) send(context, edge, {}, {});
  }
}

void SuccessorClauses::add(Context& context, Term f, std::span<const Literal> body, std::span<const Literal> head) {
  ClauseStore& store = context.store;
  if (context.is_unsatisfiable || (is_successor(f) && context.successors.is_replaced(store, f))) return;
  WaitingClause clause;
  for (const Literal literal : head) {
    const Literal seen = seen_by_predecessor(literal, f);
    if (store.has(seen, ClauseStore::unit)) return;
    clause.head.push_back(seen);
  }
  for (const Literal literal : body) {
    const Literal seen = seen_by_predecessor(literal, f);
    if (!store.has(seen, ClauseStore::unit)) clause.body.push_back(seen);
  }
  if (clause.body.empty()) {
    conclusions_.begin();
    return conclusions_.finish(store, clause.head);
  }
  effort_.count_clause(clause.body.size() + clause.head.size());
  const auto number = static_cast<std::uint32_t>(context.waiting.size());
  for (const Literal literal : clause.body) store.lists_of(literal).waiting.push_back(number);
  context.waiting.push_back(std::move(clause));
  premises_.clear();
  join(context.waiting.back(), 0, store);
}

void SuccessorClauses::resolve(std::uint32_t number, Premise premise, const Pooled<WaitingClause>& waiting,
                               ClauseStore& store) {
  if (store.is_cut() && waiting[number].head.size() > 1) return;
  premises_.assign(1, premise);
  join(waiting[number], 0, store);
}

void SuccessorClauses::join(const WaitingClause& clause, std::size_t at, ClauseStore& store) {
  effort_.count_attempt();
  if (effort_.is_stopped()) return;
  while (at < clause.body.size() && !premises_.empty() && premises_[0].literal == clause.body[at]) ++at;
  if (at == clause.body.size()) {
    conclusions_.begin();
    for (const Premise premise : premises_) conclusions_.add_side(store, premise);
    return conclusions_.finish(store, clause.head);
  }
  for_each_premise(store, clause.body[at], [&](Premise premise) {
    premises_.push_back(premise);
    join(clause, at + 1, store);
    premises_.pop_back();
  });
}

}  // namespace geminga::consequence
