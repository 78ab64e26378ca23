#include "reasoning/dl/consequence/successors.hpp"

#include <algorithm>

namespace geminga::consequence {

Successor& Successors::at(ClauseStore& store, Term f) {
  std::uint32_t& number = store.number_of(successor_key(f));
  if (number == 0) {
    Successor& made = successors_.emplace_back();
    made.f = f;
    made.replaced_by = f;
    number = static_cast<std::uint32_t>(successors_.size());
  }
  return successors_[number - 1];
}

void Successors::replace(Successor& successor, Term by) {
  successor.replaced_by = by;
  has_replaced_ = true;
  mark_changed(successor);
}

void Successors::mark_changed(Successor& successor) {
  if (successor.is_changed) return;
  successor.is_changed = true;
  changed_.push_back(static_cast<std::uint32_t>(&successor - successors_.data()));
}

Successor& Successors::take_changed() {
  Successor& successor = successors_[changed_.back()];
  changed_.pop_back();
  successor.is_changed = false;
  return successor;
}

Successor& Successors::note(ClauseStore& store, const Rules& rules, Premise premise) {
  const Literal literal = premise.literal;
  Successor& successor = at(store, literal.term());
  (literal.kind() == LiteralKind::equal ? successor.equations : successor.premises).push_back(premise);
  if (literal.kind() <= LiteralKind::different) return successor;
  const Literal seen = seen_by_successor(literal);
  if (!rules.is_trigger(seen)) return successor;
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

}  // namespace geminga::consequence
