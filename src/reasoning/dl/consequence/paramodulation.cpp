#include "reasoning/dl/consequence/paramodulation.hpp"

#include <cstdint>
#include <span>

namespace geminga::consequence {

Literal with_replaced(Literal literal, Term by) {
  switch (literal.kind()) {
    case LiteralKind::equal:
    case LiteralKind::different:
      return equality(literal.other(), by, literal.kind() == LiteralKind::different);
    case LiteralKind::unary:
      return unary(literal.predicate(), by);
    case LiteralKind::outgoing:
    case LiteralKind::incoming:
      return binary(literal.predicate(), by, literal.kind() == LiteralKind::incoming);
    case LiteralKind::reflexive:
      return make_literal(LiteralKind::reflexive, by, literal.predicate());
  }
  return literal;
}

void Paramodulation::rewrite(Premise premise, Term by, ClauseStore& store) {
  paramodulate({no_clause, equality(premise.literal.term(), by, false)}, premise, store);
}

//  G -> D v [f(x) = t]    G' -> D' v [L]
//  ------------------------------------- Eq [f(x) > t, f(x) is in L]
//  G and G' -> D v D' v L with t for f(x)
void Paramodulation::paramodulate(Premise equation, Premise into, ClauseStore& store) {
  const Term by = equation.literal.other();
  conclusions_.begin();
  conclusions_.add_side(store, equation);
  conclusions_.add_side(store, into);
  if (into.literal.kind() <= LiteralKind::different && into.literal.other() == by) {
    // t = t is true, and t is not t is false.
    if (into.literal.kind() == LiteralKind::different) conclusions_.finish(store, {});
    return;
  }
  const Literal made = with_replaced(into.literal, by);
  conclusions_.finish(store, std::span(&made, 1));
}

// Redundant premises are dropped, so that they are looked at once.
std::span<const Premise> Paramodulation::active(Pooled<Premise>& premises, const ClauseStore& store) {
  effort_.count_compared(premises.size());
  std::erase_if(premises, [&](Premise one) { return !is_active(store, one); });
  return premises;
}

void Paramodulation::apply(Premise premise, Successor& successor, ClauseStore& store, Successors& successors) {
  if (premise.literal.kind() == LiteralKind::equal) return apply_equality(premise, successor, store, successors);
  for (const Premise equation : active(successor.equations, store)) {
    if (is_active(store, equation)) paramodulate(equation, premise, store);
  }
}

// A conclusion may cut the store, which makes other premises redundant.
void Paramodulation::apply_equality(Premise premise, Successor& self, ClauseStore& store, Successors& successors) {
  const Term f = premise.literal.term();
  const Term by = premise.literal.other();
  for (auto* const premises : {&self.equations, &self.premises}) {
    for (const Premise into : active(*premises, store)) {
      if (into.literal != premise.literal && is_active(store, into)) paramodulate(premise, into, store);
    }
  }
  // The siblings of f(x) differ from it, and so from t. A sibling that is greater is rewritten by itself.
  for (std::uint32_t sibling = rules_.first_sibling(function_of(f)); sibling < function_of(f); ++sibling) {
    if (successor(sibling) != by) conclusions_.conclude(store, premise, equality(by, successor(sibling), true));
  }
  if (premise.clause != no_clause) return factor(premise, store);
  successors.replace(self, by);
}

//  G -> D v s = t v [s = t']
//  ------------------------------- Factor [s > t' > t]
//  G -> D v t is not t' v s = t'
void Paramodulation::factor(Premise premise, ClauseStore& store) {
  const Literal maximal = premise.literal;
  for (const Literal literal : head_of(store, premise)) {
    if (literal == maximal || literal.kind() != LiteralKind::equal || literal.term() != maximal.term()) continue;
    conclusions_.begin();
    conclusions_.add_body(body_of(store, premise));
    for (const Literal kept : head_of(store, premise)) {
      if (kept != literal) conclusions_.add_head(kept);
    }
    const Literal made = equality(maximal.other(), literal.other(), true);
    conclusions_.finish(store, std::span(&made, 1));
  }
}

}  // namespace geminga::consequence
