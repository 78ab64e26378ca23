// What a context tells its predecessors.
//
//  <u, v, f>    A1 and ... and Am -> L1 v ... v Ln in v    Gi -> Di v [Ai s] in u for each i
//  ---------------------------------------------------------------------------------------- Pred
//  G1 and ... and Gm -> D1 v ... v Dm v L1 s v ... v Ln s in u    [s: x to f(x), y to x; all Li are in Pr]
//
// v sends the clause once to each u that has said that all Ai may hold of its f(x). u resolves it with its own clauses.
#include <algorithm>
#include <utility>

#include "reasoning/dl/consequence/saturation.hpp"
#include "reasoning/dl/consequence/worker.hpp"

namespace geminga::consequence {

void Worker::receive_edge(const Message& message, std::span<const Literal> hypotheses) {
  Context& self = *context_;
  if (self.is_unsatisfiable) return tell({message.from, message.f, true, {}}, {}, {});
  std::uint32_t number = self.store.number_of(edge_key(message.f, message.from->number));
  if (number == 0 || !self.edges[number - 1].is_live) {
    self.edges.push_back({message.from, message.f, true, {}});
    number = static_cast<std::uint32_t>(self.edges.size());
    self.store.number_of(edge_key(message.f, message.from->number)) = number;
    const Edge& edge = self.edges.back();
    for (const Literal& unit : self.units_for_edges) tell(edge, {}, std::span(&unit, 1));
    for (const ClauseNumber clause : self.for_all_edges) {
      if (self.store.is_live(clause)) tell(edge, {}, self.store.head(clause));
    }
  }
  Edge& edge = self.edges[number - 1];
  for (const Literal hypothesis : hypotheses) {
    const auto place = std::ranges::lower_bound(edge.hypotheses, hypothesis);
    if (place != edge.hypotheses.end() && *place == hypothesis) continue;
    edge.hypotheses.insert(place, hypothesis);
    if (self.store.set(in_body(hypothesis), ClauseStore::assumed)) {
      begin_conclusion();
      conclusion_body_.push_back(hypothesis);
      end_conclusion(std::span(&hypothesis, 1));
    }
    auto& lists = self.store.lists_of(in_body(hypothesis));
    lists.waiting.push_back(number - 1);
    for (const ClauseNumber clause : lists.maximal) {
      if (!self.store.is_live(clause)) continue;
      if (!std::ranges::includes(edge.hypotheses, self.store.body(clause))) continue;
      tell(edge, self.store.body(clause), self.store.head(clause));
    }
  }
}

void Worker::tell(const Edge& edge, std::span<const Literal> body, std::span<const Literal> head) {
  saturation_.post(*edge.from, MessageKind::clause, context_, edge.f, body, head, number_);
}

void Worker::tell_predecessors(Literal unit) {
  context_->units_for_edges.push_back(unit);
  for (const Edge& edge : context_->edges) {
    if (edge.is_live) tell(edge, {}, std::span(&unit, 1));
  }
}

void Worker::tell_predecessors(ClauseNumber clause) {
  ClauseStore& store = context_->store;
  const auto body = store.body(clause);
  const auto head = store.head(clause);
  // A tautology is of no use there.
  if (std::ranges::any_of(body, [&](Literal literal) { return std::ranges::find(head, literal) != head.end(); }))
    return;
  if (body.empty()) {
    context_->for_all_edges.push_back(clause);
    for (const Edge& edge : context_->edges) {
      if (edge.is_live) tell(edge, body, head);
    }
    return;
  }
  for (const Literal literal : body) store.lists_of(in_body(literal)).maximal.push_back(clause);
  for (const std::uint32_t number : store.lists_of(in_body(body[0])).waiting) {
    const Edge& edge = context_->edges[number];
    if (edge.is_live && std::ranges::includes(edge.hypotheses, body)) tell(edge, body, head);
  }
}

void Worker::receive_clause(const Message& message, std::span<const Literal> body, std::span<const Literal> head) {
  Context& self = *context_;
  if (self.is_unsatisfiable || (is_successor(message.f) && is_replaced(message.f))) return;
  ForeignClause clause;
  for (const Literal literal : head) {
    const Literal seen = seen_by_predecessor(literal, message.f);
    if (self.store.has(seen, ClauseStore::unit)) return;
    clause.head.push_back(seen);
  }
  for (const Literal literal : body) {
    const Literal seen = seen_by_predecessor(literal, message.f);
    if (!self.store.has(seen, ClauseStore::unit)) clause.body.push_back(seen);
  }
  if (clause.body.empty()) {
    begin_conclusion();
    return end_conclusion(clause.head);
  }
  derived_ += 1 + (clause.body.size() + clause.head.size()) / literals_per_clause;
  const auto number = static_cast<std::uint32_t>(self.foreign.size());
  for (const Literal literal : clause.body) self.store.lists_of(literal).waiting.push_back(number);
  self.foreign.push_back(std::move(clause));
  premises_.clear();
  join_foreign(self.foreign.back(), 0);
}

void Worker::resolve_foreign(std::uint32_t foreign, Premise premise) {
  if (context_->is_cut && context_->foreign[foreign].head.size() > 1) return;
  premises_.assign(1, premise);
  join_foreign(context_->foreign[foreign], 0);
}

void Worker::join_foreign(const ForeignClause& clause, std::size_t at) {
  count_attempt();
  if (is_stopped_) return;
  while (at < clause.body.size() && !premises_.empty() && premises_[0].literal == clause.body[at]) ++at;
  if (at == clause.body.size()) {
    begin_conclusion();
    for (const Premise premise : premises_) add_side(premise);
    return end_conclusion(clause.head);
  }
  for_each_premise(clause.body[at], [&](Premise premise) {
    premises_.push_back(premise);
    join_foreign(clause, at + 1);
    premises_.pop_back();
  });
}

}  // namespace geminga::consequence
