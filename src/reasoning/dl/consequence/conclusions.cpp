// Builds conclusions from premises: their bodies together, and their heads with what replaces the resolved literals.
#include "reasoning/dl/consequence/saturation.hpp"
#include "reasoning/dl/consequence/worker.hpp"

namespace geminga::consequence {

std::span<const Literal> Worker::body_of(Premise premise) const {
  return premise.clause == no_clause ? std::span<const Literal>() : context_->store.body(premise.clause);
}

std::span<const Literal> Worker::head_of(Premise premise) const {
  return premise.clause == no_clause ? std::span<const Literal>() : context_->store.head(premise.clause);
}

void Worker::begin_conclusion() {
  conclusion_body_.clear();
  conclusion_head_.clear();
}

void Worker::add_side(Premise premise) {
  const auto body = body_of(premise);
  conclusion_body_.insert(conclusion_body_.end(), body.begin(), body.end());
  for (const Literal literal : head_of(premise)) {
    if (literal != premise.literal) conclusion_head_.push_back(literal);
  }
}

void Worker::end_conclusion(std::span<const Literal> head) {
  if (conclusion_body_.empty() && conclusion_head_.size() + head.size() <= 1) {
    if (head.empty() && conclusion_head_.empty()) {
      is_false_derived_ = true;
    } else {
      const Literal unit = head.empty() ? conclusion_head_[0] : head[0];
      if (!context_->store.has(unit, ClauseStore::unit)) units_.push_back(unit);
    }
    return;
  }
  if (conclusion_head_.size() + head.size() > 1 && !may_have_alternatives()) return;
  if (literals_.size() > max_waiting_literals) {
    saturation_.give_up();
    is_stopped_ = true;
    return;
  }
  counts_.push_back(static_cast<std::uint32_t>(conclusion_body_.size()));
  counts_.push_back(static_cast<std::uint32_t>(conclusion_head_.size() + head.size()));
  literals_.insert(literals_.end(), conclusion_body_.begin(), conclusion_body_.end());
  literals_.insert(literals_.end(), conclusion_head_.begin(), conclusion_head_.end());
  literals_.insert(literals_.end(), head.begin(), head.end());
}

void Worker::conclude(Premise premise, Literal instead) {
  if (premise.clause == no_clause) {
    if (!context_->store.has(instead, ClauseStore::unit)) units_.push_back(instead);
    return;
  }
  begin_conclusion();
  add_side(premise);
  end_conclusion(std::span(&instead, 1));
}

/// L with t in place of f(x), which is L's greatest term. The other term of an equality must not be t.
Literal Worker::replaced(Literal literal, Term by) const {
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

}  // namespace geminga::consequence
