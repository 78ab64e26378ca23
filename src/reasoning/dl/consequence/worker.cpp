#include "reasoning/dl/consequence/worker.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace geminga::consequence {

Worker::Worker(const Rules& rules, SharedEffort& shared, const Outbox& outbox)
    : rules_(rules),
      shared_(shared),
      effort_(shared),
      outbox_(outbox),
      conclusions_(effort_, shared),
      filing_(rules, effort_, shared),
      hyperresolution_(rules, effort_, conclusions_),
      paramodulation_(rules, effort_, conclusions_),
      successor_rule_(rules, outbox_),
      predecessor_rule_(conclusions_, outbox_),
      successor_clauses_(effort_, conclusions_),
      nominal_rules_(rules, conclusions_, outbox_) {}

void Worker::work(Context& context) {
  while (context.mailbox.take(messages_, message_literals_, shared_.is_cut_off())) {
    shared_.count_received(messages_.size());
    receive(context);
    saturate(context);
    effort_.report();
  }
}

void Worker::receive(Context& context) {
  std::size_t at = 0;
  for (const Message& message : messages_) {
    const auto body = std::span<const Literal>(message_literals_).subspan(at, message.body);
    const auto head = std::span<const Literal>(message_literals_).subspan(at + message.body, message.head);
    at += message.body + message.head;
    receive(context, message, body, head);
    file_conclusions(context);
  }
}

void Worker::receive(Context& context, const Message& message, std::span<const Literal> body,
                     std::span<const Literal> head) {
  switch (message.kind) {
    case MessageKind::start:
      return start(context, context.store);
    case MessageKind::edge:
      return predecessor_rule_.add_edge(context, *message.from, message.f, body);
    case MessageKind::no_edge:
      return PredecessorRule::remove_edge(context.predecessors, *message.from, message.f);
    case MessageKind::clause:
      return successor_clauses_.add(context, message.f, body, head);
    case MessageKind::exists:
      return note_existence(context);
    case MessageKind::inherit:
      return nominal_rules_.receive_inheritor(context, *message.from);
    case MessageKind::fact:
      return nominal_rules_.receive_fact(context, head[0]);
  }
}

//  ----------- Core [A is in core(v)]      -------- [G -> D in O; G is empty; v is not of values]
//  true -> A                               G -> D
void Worker::start(const Context& context, ClauseStore& store) {
  for (const Literal literal : context.key.core) conclusions_.add_unit(literal);
  if (context.key.is_value) return;
  for (const std::uint32_t number : rules_.always()) {
    hyperresolution_.fire(rules_.rule(number), {store, context.successors});
  }
}

void Worker::note_existence(Context& context) {
  if (context.is_nonempty) return;
  context.is_nonempty = true;
  if (context.is_unsatisfiable) return shared_.contradict();
  nominal_rules_.tell_all(context);
  for (Successor& successor : context.successors.all()) successor_rule_.tell_existence(context, successor);
}

void Worker::saturate(Context& context) {
  while (!context.is_unsatisfiable && effort_.may_continue()) {
    ClauseQueue& queue = context.queue;
    if (!queue.units.empty()) {
      const Literal literal = queue.units.back();
      queue.units.pop_back();
      process_unit(context, literal);
    } else if (!queue.clauses.empty()) {
      const ClauseNumber clause = queue.clauses.back();
      queue.clauses.pop_back();
      if (context.store.is_live(clause)) process_clause(context, clause);
    } else if (context.successors.has_changed()) {
      successor_rule_.apply(context, context.successors.take_changed());
    } else {
      return;
    }
    file_conclusions(context);
  }
}

void Worker::process_unit(Context& context, Literal literal) {
  if (!context.store.set(literal, ClauseStore::active_unit)) return;
  process(context, {no_clause, literal});
  if (rules_.has_nominals()) nominal_rules_.apply(context, literal);
  if (is_of_predecessor(literal)) predecessor_rule_.tell(context, literal);
}

void Worker::process_clause(Context& context, ClauseNumber clause) {
  ClauseStore& store = context.store;
  store.activate(clause);
  const std::size_t maximal = maximal_count(rules_, context.answers_queries, store.head(clause));
  for (std::size_t at = 0; at < maximal && store.is_live(clause); ++at) {
    process(context, {clause, store.head(clause)[at]});
  }
  if (maximal == 0 || is_of_predecessor(store.head(clause)[0])) predecessor_rule_.tell(context, clause);
}

void Worker::process(Context& context, Premise premise) {
  ClauseStore& store = context.store;
  if (const Term term = premise.literal.term(); is_successor(term)) {
    Successors& successors = context.successors;
    if (const Term by = successors.replacement(store, term); by != term) {
      return paramodulation_.rewrite(premise, by, store);
    }
    paramodulation_.apply(premise, successors.note(store, rules_, premise), store, successors);
    if (successors.is_replaced(store, term)) return;
  }
  match(context, premise);
  // Conclusions are filed afterwards, so the lists do not change here.
  if (const auto* const lists = store.lists(premise.literal); lists != nullptr) {
    for (const std::uint32_t number : lists->waiting) {
      successor_clauses_.resolve(number, premise, context.waiting, store);
    }
  }
}

/// Matches the premise with the rules that have its literal in their bodies.
void Worker::match(Context& context, Premise premise) {
  const Literal literal = premise.literal;
  ClauseStore& store = context.store;
  const MatchedContext matched{store, context.successors};
  const auto note_neighbour = [&](bool is_incoming) {
    store.lists_of(neighbours(literal.predicate(), is_incoming))
        .maximal.push_back(static_cast<std::uint32_t>(literal.term()));
  };
  const auto apply_each = [&](std::span<const Occurrence> occurrences, Term neighbour) {
    for (const Occurrence& found : occurrences) hyperresolution_.apply(premise, found, neighbour, matched);
  };
  switch (literal.kind()) {
    case LiteralKind::equal:
    case LiteralKind::different:
      return;
    case LiteralKind::unary:
      if (literal.term() != x_term) return;
      for (const Literal told : rules_.told(literal.predicate())) conclusions_.conclude(store, premise, told);
      apply_each(rules_.with_unary(literal.predicate()), x_term);
      if (const Expansion* const expansion = rules_.expansion(literal.predicate())) {
        hyperresolution_.expand(premise, *expansion, store);
      }
      return;
    case LiteralKind::outgoing:
    case LiteralKind::incoming: {
      const bool is_incoming = literal.kind() == LiteralKind::incoming;
      if (store.set(literal, ClauseStore::listed)) note_neighbour(is_incoming);
      return apply_each(rules_.with_role(literal.predicate(), is_incoming), literal.term());
    }
    case LiteralKind::reflexive:
      if (literal.term() != x_term) return;
      for (const bool is_incoming : {false, true}) {
        if (store.set(neighbours(literal.predicate(), is_incoming), ClauseStore::listed)) note_neighbour(is_incoming);
        apply_each(rules_.with_role(literal.predicate(), is_incoming), x_term);
      }
      return apply_each(rules_.with_reflexive(literal.predicate()), x_term);
  }
}

void Worker::file_conclusions(Context& context) {
  const bool is_satisfiable = filing_.file(conclusions_, context);
  conclusions_.clear();
  if (is_satisfiable || context.is_unsatisfiable) return;
  context.is_unsatisfiable = true;
  effort_.count_unit();
  if (context.is_nonempty) shared_.contradict();
  predecessor_rule_.tell_unsatisfiable(context);
  nominal_rules_.tell_unsatisfiable(context);
  // An unsatisfiable context needs no clauses.
  context.store.clear();
  context.queue = {};
  context.successors = {};
  context.predecessors = {};
  context.waiting = {};
  context.nominal_links = {};
}

}  // namespace geminga::consequence
