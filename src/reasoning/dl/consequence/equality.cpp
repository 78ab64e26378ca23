// Equality by ordered paramodulation: the smaller term replaces the greater one.

#include "reasoning/dl/consequence/worker.hpp"

namespace geminga::consequence {

bool Worker::is_replaced(Term f) const {
  if (!context_->has_replaced) return false;
  const std::uint32_t number = context_->store.find_number(successor_key(f));
  return number != 0 && context_->successors[number - 1].replaced_by != f;
}

//  G -> D v [f(x) = t]    G' -> D' v [L]
//  ------------------------------------- Eq [f(x) > t, f(x) is in L]
//  G and G' -> D v D' v L with t for f(x)
void Worker::paramodulate(Premise equation, Premise into) {
  const Term by = equation.literal.other();
  begin_conclusion();
  add_side(equation);
  add_side(into);
  if (into.literal.kind() <= LiteralKind::different && into.literal.other() == by) {
    // t = t is true, and t is not t is false.
    if (into.literal.kind() == LiteralKind::different) end_conclusion({});
    return;
  }
  const Literal made = replaced(into.literal, by);
  end_conclusion(std::span(&made, 1));
}

void Worker::apply_equality(Premise premise) {
  const Term f = premise.literal.term();
  const Term by = premise.literal.other();
  for (const Literal literal : successor_of(f).literals) {
    if (literal == premise.literal) continue;
    for_each_premise(literal, [&](Premise into) { paramodulate(premise, into); });
  }
  // The siblings of f(x) differ from it, and so from t. A sibling that is greater is rewritten by itself.
  for (std::uint32_t sibling = rules_.first_sibling(function_of(f)); sibling < function_of(f); ++sibling) {
    if (successor(sibling) != by) conclude(premise, equality(by, successor(sibling), true));
  }
  if (premise.clause != no_clause) return factor(premise);
  Successor& self = successor_of(f);
  self.replaced_by = by;
  context_->has_replaced = true;
  mark_changed(self);
}

void Worker::apply_equalities_to(Premise premise, const Successor& successor) {
  if (premise.literal.kind() == LiteralKind::equal) return apply_equality(premise);
  for (const Literal literal : successor.literals) {
    if (literal.kind() != LiteralKind::equal) continue;
    for_each_premise(literal, [&](Premise equation) { paramodulate(equation, premise); });
  }
}

//  G -> D v s = t v [s = t']
//  ------------------------------- Factor [s > t' > t]
//  G -> D v t is not t' v s = t'
void Worker::factor(Premise premise) {
  const Literal maximal = premise.literal;
  for (const Literal literal : head_of(premise)) {
    if (literal == maximal || literal.kind() != LiteralKind::equal || literal.term() != maximal.term()) continue;
    begin_conclusion();
    const auto body = body_of(premise);
    conclusion_body_.assign(body.begin(), body.end());
    for (const Literal kept : head_of(premise)) {
      if (kept != literal) conclusion_head_.push_back(kept);
    }
    const Literal made = equality(maximal.other(), literal.other(), true);
    end_conclusion(std::span(&made, 1));
  }
}

}  // namespace geminga::consequence
