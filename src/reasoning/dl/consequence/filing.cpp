#include "reasoning/dl/consequence/filing.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>

#include "base/sorted.hpp"
#include "reasoning/dl/consequence/paramodulation.hpp"

namespace geminga::consequence {

std::size_t maximal_count(const Rules& rules, bool answers_queries, std::span<const Literal> head) {
  if (head.empty()) return 0;
  if (!answers_queries || !rules.is_query(head[0])) return 1;
  return static_cast<std::size_t>(
      std::ranges::find_if_not(head, [&](Literal literal) { return rules.is_query(literal); }) - head.begin());
}

bool Filing::file(const Conclusions& conclusions, Context& context) {
  // Units first, because they make others redundant.
  bool is_satisfiable = !conclusions.has_contradiction();
  for (const Literal unit : conclusions.units()) is_satisfiable = add_unit(unit, context) && is_satisfiable;
  if (!is_satisfiable) return false;
  conclusions.for_each_clause([&](std::span<const Literal> body, std::span<const Literal> head) {
    body_.assign(body.begin(), body.end());
    head_.assign(head.begin(), head.end());
    is_satisfiable = add_clause(context);
    return is_satisfiable;
  });
  return is_satisfiable;
}

//  G -> D v t is not t            G -> D    G' -> D'
//  ------------------- Ineq       ------------------ Elim [G' is part of G, D' of D]
//  G -> D                         drop G -> D
//
// Elim includes two more cases. With true -> f(x) = t every other f(x) is written as t. Siblings f(x) and g(x) are
// different, and so are x and y. If x and y were equal, the context would not be needed, because its things are written
// in another way.
bool Filing::simplify_head(const Context& context) {
  std::size_t kept = 0;
  for (Literal literal : head_) {
    while (is_successor(literal.term()) && context.successors.is_replaced(context.store, literal.term())) {
      const Term by = context.successors.replacement(context.store, literal.term());
      if (literal.kind() <= LiteralKind::different && literal.other() == by) {
        // t = t is true, t is not t is false.
        if (literal.kind() == LiteralKind::equal) return false;
        literal = no_literal;
        break;
      }
      literal = with_replaced(literal, by);
    }
    if (literal == no_literal) continue;
    if (literal.kind() == LiteralKind::different && literal.term() == y_term) return false;
    if (literal.kind() <= LiteralKind::different && is_successor(literal.other()) &&
        rules_.are_siblings(function_of(literal.term()), function_of(literal.other()))) {
      if (literal.kind() == LiteralKind::different) return false;
      continue;
    }
    if (context.store.has(literal, ClauseStore::unit)) return false;
    head_[kept++] = literal;
  }
  head_.resize(kept);
  std::ranges::sort(head_, std::greater<>());
  head_.erase(std::ranges::unique(head_).begin(), head_.end());
  return std::ranges::none_of(head_, [&](Literal literal) {
    return literal.kind() == LiteralKind::different &&
           std::ranges::binary_search(head_, equality(literal.term(), literal.other(), false), std::greater<>());
  });
}

bool Filing::add_clause(Context& context) {
  ClauseStore& store = context.store;
  if (!simplify_head(context)) return true;
  std::erase_if(body_, [&](Literal literal) { return store.has(literal, ClauseStore::unit); });
  base::sort_unique(body_);
  bool is_satisfiable = true;
  if (body_.empty() && head_.empty()) {
    is_satisfiable = false;
  } else if (body_.empty() && head_.size() == 1) {
    is_satisfiable = add_unit(head_[0], context);
  } else if (head_.size() > 1 && store.is_cut()) {
    return true;
  } else if (body_.size() > std::numeric_limits<std::uint16_t>::max() ||
             head_.size() > std::numeric_limits<std::uint16_t>::max()) {
    shared_.give_up();
  } else if (!store.is_redundant(body_, head_)) {
    effort_.count_clause(body_.size() + head_.size());
    for (const Literal literal : head_) note_open(literal, context);
    context.queue.clauses.push_back(store.insert(body_, head_, maximal_count(rules_, context.answers_queries, head_)));
  }
  effort_.count_compared(store.take_compared());
  return is_satisfiable;
}

bool Filing::add_unit(Literal literal, Context& context) {
  if (literal.kind() <= LiteralKind::different ||
      (is_successor(literal.term()) && context.successors.is_replaced(context.store, literal.term()))) {
    // It may be simplified. There are few of this kind.
    head_.assign(1, literal);
    if (!simplify_head(context)) return true;
    if (head_.empty()) return false;
    literal = head_[0];
  }
  if (!context.store.insert_unit(literal)) return true;
  effort_.count_unit();
  note_open(literal, context);
  context.queue.units.push_back(literal);
  return true;
}

}  // namespace geminga::consequence
