// Chooses the context of each successor, and what that context is told.
#include <algorithm>

#include "reasoning/dl/consequence/saturation.hpp"
#include "reasoning/dl/consequence/worker.hpp"

namespace geminga::consequence {

Successor& Worker::successor_of(Term f) {
  std::uint32_t& number = context_->store.number_of(successor_key(f));
  if (number == 0) {
    Successor& made = context_->successors.emplace_back();
    made.f = f;
    made.replaced_by = f;
    number = static_cast<std::uint32_t>(context_->successors.size());
  }
  return context_->successors[number - 1];
}

void Worker::mark_changed(Successor& successor) {
  if (successor.is_changed) return;
  successor.is_changed = true;
  context_->changed_successors.push_back(static_cast<std::uint32_t>(&successor - context_->successors.data()));
}

const Successor& Worker::note_about_successor(Premise premise) {
  const Literal literal = premise.literal;
  Successor& successor = successor_of(literal.term());
  if (context_->store.set(literal, ClauseStore::noted)) successor.literals.push_back(literal);
  if (literal.kind() <= LiteralKind::different) return successor;
  const Literal seen = seen_by_successor(literal);
  if (!rules_.is_trigger(seen)) return successor;
  const bool is_unit = premise.clause == no_clause;
  if (is_unit && !successor.is_certain) {
    successor.is_certain = true;
    mark_changed(successor);
  }
  auto& known = is_unit && seen.kind() == LiteralKind::unary ? successor.certain : successor.possible;
  const auto place = std::ranges::lower_bound(known, seen);
  if (place != known.end() && *place == seen) return successor;
  known.insert(place, seen);
  mark_changed(successor);
  return successor;
}

//  G -> D v [A] in u; f(x) is in A
//  --------------------------------------------------------------- Succ [K1: the L of Su with true -> L f in u]
//  <u, v, f> for a v with core(v) part of K1                            [K2: those with G -> D v [L f] in u]
//  L -> L in v for each L of K2 that is not in core(v)
//
// K1's concepts are the core ("eager" in the paper). So what certainly holds of a successor is a unit in its context,
// and a Horn ontology has units nearly everywhere. The successor's roles to x are not in the core, so that equal
// successors of different roles share one context, as in EL. A successor that is not certain to exist has a context of
// its function.
void Worker::apply_succ(Successor& successor) {
  if (successor.replaced_by != successor.f) {
    if (successor.target != nullptr) {
      saturation_.post(*successor.target, MessageKind::no_edge, context_, successor.f, {}, {}, number_);
    }
    successor.target = nullptr;
    return;
  }
  ContextKey key;
  key.is_value = rules_.is_value(function_of(successor.f));
  if (successor.is_certain) {
    key.core = successor.certain;
  } else {
    key.function = function_of(successor.f);
  }
  if (successor.target == nullptr || successor.target->key != key) {
    if (successor.target != nullptr) {
      saturation_.post(*successor.target, MessageKind::no_edge, context_, successor.f, {}, {}, number_);
    }
    successor.target = &saturation_.context_for(std::move(key), number_);
    successor.told = 0;
    successor.knows_existence = false;
  } else if (successor.told == successor.possible.size()) {
    return;
  }
  successor.told = successor.possible.size();
  body_.clear();
  std::ranges::set_difference(successor.possible, successor.target->key.core, std::back_inserter(body_));
  saturation_.post(*successor.target, MessageKind::edge, context_, successor.f, body_, {}, number_);
  tell_existence(successor);
}

}  // namespace geminga::consequence
