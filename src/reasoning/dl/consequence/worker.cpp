#include "reasoning/dl/consequence/worker.hpp"

#include <algorithm>
#include <functional>
#include <mutex>

#include "base/sorted.hpp"
#include "reasoning/dl/consequence/saturation.hpp"

namespace geminga::consequence {

Worker::Worker(Saturation& saturation, unsigned number)
    : saturation_(saturation), rules_(saturation.rules()), number_(number) {}

void Worker::work(Context& context) {
  context_ = &context;
  derived_ = 0;
  while (true) {
    {
      const std::lock_guard guard(context.lock);
      if (context.mailbox.empty() || saturation_.is_cut_off()) {
        context.is_scheduled = false;
        break;
      }
      messages_.clear();
      message_literals_.clear();
      messages_.swap(context.mailbox);
      message_literals_.swap(context.mailbox_literals);
    }
    saturation_.note_received(messages_.size());
    receive();
    saturate_locally();
    saturation_.count(derived_);
    derived_ = 0;
  }
}

void Worker::receive() {
  std::size_t at = 0;
  for (const Message& message : messages_) {
    const auto body = std::span(message_literals_).subspan(at, message.body);
    const auto head = std::span(message_literals_).subspan(at + message.body, message.head);
    at += message.body + message.head;
    switch (message.kind) {
      case MessageKind::start:
        start();
        break;
      case MessageKind::edge:
        receive_edge(message, body);
        break;
      case MessageKind::no_edge:
        for (Edge& edge : context_->edges) {
          if (edge.from == message.from && edge.f == message.f) edge.is_live = false;
        }
        break;
      case MessageKind::clause:
        receive_clause(message, body, head);
        break;
      case MessageKind::exists:
        receive_existence();
        break;
      case MessageKind::inherit:
        receive_inheritor(message.from);
        break;
      case MessageKind::fact:
        receive_fact(head[0]);
        break;
    }
    file_conclusions();
  }
}

void Worker::saturate_locally() {
  Context& self = *context_;
  while (!self.is_unsatisfiable && !is_stopped_) {
    if (derived_ > 1000) {
      if (!saturation_.count(derived_)) return;
      derived_ = 0;
    }
    if (!self.unit_queue.empty()) {
      const Literal literal = self.unit_queue.back();
      self.unit_queue.pop_back();
      activate_unit(literal);
    } else if (!self.clause_queue.empty()) {
      const ClauseNumber clause = self.clause_queue.back();
      self.clause_queue.pop_back();
      if (self.store.is_live(clause)) activate_clause(clause);
    } else if (!self.changed_successors.empty()) {
      Successor& successor = self.successors[self.changed_successors.back()];
      self.changed_successors.pop_back();
      successor.is_changed = false;
      apply_succ(successor);
    } else {
      return;
    }
    file_conclusions();
  }
}

//  ----------- Core [A is in core(v)]      -------- [G -> D in O; G is empty; v is not of values]
//  true -> A                               G -> D
void Worker::start() {
  for (const Literal literal : context_->key.core) add_unit(literal);
  if (context_->key.is_value) return;
  for (const std::uint32_t number : rules_.always()) {
    premises_.clear();
    binding_.assign(1, x_term);
    conclude_rule(rules_.rule(number));
  }
}

void Worker::activate_unit(Literal literal) {
  if (!context_->store.set(literal, ClauseStore::active_unit)) return;
  activate({no_clause, literal});
  if (rules_.has_nominals()) apply_nominals(literal);
  if (is_of_predecessor(literal)) tell_predecessors(literal);
}

void Worker::activate_clause(ClauseNumber clause) {
  ClauseStore& store = context_->store;
  store.activate(clause);
  const std::size_t maximal = maximal_count(store.head(clause));
  for (std::size_t at = 0; at < maximal && store.is_live(clause); ++at) activate({clause, store.head(clause)[at]});
  if (maximal == 0 || is_of_predecessor(store.head(clause)[0])) tell_predecessors(clause);
}

std::size_t Worker::maximal_count(std::span<const Literal> head) const {
  if (head.empty()) return 0;
  if (!context_->answers_queries || !rules_.is_query(head[0])) return 1;
  return static_cast<std::size_t>(
      std::ranges::find_if_not(head, [this](Literal literal) { return rules_.is_query(literal); }) - head.begin());
}

void Worker::activate(Premise premise) {
  const Literal literal = premise.literal;
  ClauseStore& store = context_->store;
  if (is_successor(literal.term())) {
    if (is_replaced(literal.term())) {
      // The equation was derived while this waited.
      return paramodulate({no_clause, equality(literal.term(), successor_of(literal.term()).replaced_by, false)},
                          premise);
    }
    apply_equalities_to(premise, note_about_successor(premise));
    if (is_replaced(literal.term())) return;
  }
  switch (literal.kind()) {
    case LiteralKind::equal:
    case LiteralKind::different:
      break;
    case LiteralKind::unary:
      if (literal.term() != x_term) break;
      for (const Literal told : rules_.told(literal.predicate())) conclude(premise, told);
      for (const Occurrence& occurrence : rules_.with_unary(literal.predicate())) hyper(premise, occurrence, x_term);
      if (const Expansion* const expansion = rules_.expansion(literal.predicate())) expand(premise, *expansion);
      break;
    case LiteralKind::outgoing:
    case LiteralKind::incoming: {
      const bool is_incoming = literal.kind() == LiteralKind::incoming;
      if (store.set(literal, ClauseStore::listed)) {
        store.lists_of(neighbours(literal.predicate(), is_incoming))
            .maximal.push_back(static_cast<std::uint32_t>(literal.term()));
      }
      for (const Occurrence& found : rules_.with_role(literal.predicate(), is_incoming)) {
        hyper(premise, found, literal.term());
      }
      break;
    }
    case LiteralKind::reflexive:
      if (literal.term() != x_term) break;
      for (const bool is_incoming : {false, true}) {
        if (store.set(neighbours(literal.predicate(), is_incoming), ClauseStore::listed)) {
          store.lists_of(neighbours(literal.predicate(), is_incoming))
              .maximal.push_back(static_cast<std::uint32_t>(x_term));
        }
        for (const Occurrence& found : rules_.with_role(literal.predicate(), is_incoming))
          hyper(premise, found, x_term);
      }
      for (const Occurrence& found : rules_.with_reflexive(literal.predicate())) hyper(premise, found, x_term);
      break;
  }
  // Conclusions are filed afterwards, so the lists do not change here.
  if (const auto* const lists = store.lists(literal); lists != nullptr) {
    for (const std::uint32_t foreign : lists->waiting) resolve_foreign(foreign, premise);
  }
}

void Worker::become_unsatisfiable() {
  Context& self = *context_;
  if (self.is_unsatisfiable) return;
  self.is_unsatisfiable = true;
  ++derived_;
  if (self.is_nonempty) saturation_.contradict();
  for (const Edge& edge : self.edges) {
    if (edge.is_live) tell(edge, {}, {});
  }
  for (Context* const inheritor : self.inheritors) {
    saturation_.post(*inheritor, MessageKind::clause, context_, x_term, {}, {}, number_);
  }
  self.store.clear();
  self.unit_queue = {};
  self.clause_queue = {};
  self.successors = {};
  self.changed_successors = {};
  self.edges = {};
  self.foreign = {};
  self.nominals = {};
  self.inheritors = {};
}

void Worker::file_conclusions() {
  // Units first, because they make others redundant.
  for (const Literal unit : units_) add_unit(unit);
  units_.clear();
  std::size_t at = 0;
  for (std::size_t i = 0; i < counts_.size() && !is_false_derived_; i += 2) {
    const auto first = literals_.begin() + static_cast<std::ptrdiff_t>(at);
    const auto middle = first + counts_[i];
    body_.assign(first, middle);
    head_.assign(middle, middle + counts_[i + 1]);
    at += counts_[i] + counts_[i + 1];
    add(body_, head_);
  }
  literals_.clear();
  counts_.clear();
  if (is_false_derived_) become_unsatisfiable();
  is_false_derived_ = false;
}

//  G -> D v t is not t            G -> D    G' -> D'
//  ------------------- Ineq       ------------------ Elim [G' is part of G, D' of D]
//  G -> D                         drop G -> D
//
// Elim includes two more cases. With true -> f(x) = t every other f(x) is written as t. Siblings f(x) and g(x) are
// different, and so are x and y. If x and y were equal, the context would not be needed, because its things are written
// in another way.
bool Worker::simplify_head(std::vector<Literal>& head) {
  std::size_t kept = 0;
  for (Literal literal : head) {
    while (is_successor(literal.term()) && is_replaced(literal.term())) {
      const Term by = successor_of(literal.term()).replaced_by;
      if (literal.kind() <= LiteralKind::different && literal.other() == by) {
        // t = t is true, t is not t is false.
        if (literal.kind() == LiteralKind::equal) return false;
        literal = no_literal;
        break;
      }
      literal = replaced(literal, by);
    }
    if (literal == no_literal) continue;
    if (literal.kind() == LiteralKind::different && literal.term() == y_term) return false;
    if (literal.kind() <= LiteralKind::different && is_successor(literal.other()) &&
        rules_.are_siblings(function_of(literal.term()), function_of(literal.other()))) {
      if (literal.kind() == LiteralKind::different) return false;
      continue;
    }
    if (context_->store.has(literal, ClauseStore::unit)) return false;
    head[kept++] = literal;
  }
  head.resize(kept);
  std::ranges::sort(head, std::greater<>());
  head.erase(std::ranges::unique(head).begin(), head.end());
  return std::ranges::none_of(head, [&](Literal literal) {
    return literal.kind() == LiteralKind::different &&
           std::ranges::binary_search(head, equality(literal.term(), literal.other(), false), std::greater<>());
  });
}

bool Worker::may_have_alternatives() {
  if (context_->is_cut) return false;
  if (++context_->alternatives > saturation_.max_alternatives()) cut();
  return !context_->is_cut;
}

// A context with many alternatives would derive every combination of them. It goes on without them. What it derives
// from the rest is sound, and what may be missing is the gap.
void Worker::cut() {
  context_->is_cut = true;
  context_->store.drop_alternatives();
  saturation_.note_cut_context();
}

void Worker::add(std::vector<Literal>& body, std::vector<Literal>& head) {
  Context& self = *context_;
  if (!simplify_head(head)) return;
  std::erase_if(body, [&](Literal literal) { return self.store.has(literal, ClauseStore::unit); });
  base::sort_unique(body);
  if (body.empty() && head.empty()) {
    is_false_derived_ = true;
  } else if (body.empty() && head.size() == 1) {
    add_unit(head[0]);
  } else if (head.size() > 1 && self.is_cut) {
    return;
  } else if (body.size() > std::numeric_limits<std::uint16_t>::max() ||
             head.size() > std::numeric_limits<std::uint16_t>::max()) {
    saturation_.give_up();
  } else if (!self.store.is_redundant(body, head)) {
    derived_ += 1 + (body.size() + head.size()) / literals_per_clause;
    for (const Literal literal : head) note_open(literal);
    self.clause_queue.push_back(self.store.insert(body, head, maximal_count(head)));
  }
  compared_ += self.store.take_compared();
  count_attempts(compared_ / compared_per_attempt);
  compared_ %= compared_per_attempt;
}

void Worker::add_unit(Literal literal) {
  if (literal.kind() <= LiteralKind::different || (is_successor(literal.term()) && is_replaced(literal.term()))) {
    // It may be simplified. There are few of this kind.
    std::vector<Literal> head{literal};
    if (!simplify_head(head)) return;
    if (head.empty()) {
      is_false_derived_ = true;
      return;
    }
    literal = head[0];
  }
  if (!context_->store.insert_unit(literal)) return;
  ++derived_;
  note_open(literal);
  context_->unit_queue.push_back(literal);
}

}  // namespace geminga::consequence
