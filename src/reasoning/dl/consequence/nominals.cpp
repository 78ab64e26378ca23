// Rules for nominals. They are sound and cheap, and complete for facts without alternatives.
//
// A context exists if some thing is certain to be in it: the context of an individual, the one with an empty core, and
// those of the certain successors of a context that exists. Legend: {a} the nominal of a, t s terms, a* the context of
// {a}.

#include "reasoning/dl/consequence/saturation.hpp"
#include "reasoning/dl/consequence/worker.hpp"

namespace geminga::consequence {

void Worker::apply_nominals(Literal unit) {
  if (unit.kind() == LiteralKind::unary && rules_.is_nominal(unit.predicate())) apply_nominal(unit);
  if (unit.term() != x_term || !context_->is_nonempty) return;
  for (const std::uint32_t nominal : context_->nominals) tell_nominal(nominal, unit);
}

void Worker::apply_nominal(Literal unit) {
  //  true -> {a}(s)    true -> {a}(t)
  //  --------------------------------
  //  true -> s = t
  std::uint32_t& first = context_->store.number_of(nominal_key(unit.predicate()));
  if (first == 0) {
    first = static_cast<std::uint32_t>(unit.term()) + 1;
  } else if (const Term known{first - 1}; known != unit.term()) {
    units_.push_back(equality(known, unit.term(), false));
  }
  if (unit.term() != x_term) return;
  context_->nominals.push_back(unit.predicate());
  if (!is_context_of(unit.predicate())) {
    saturation_.post(saturation_.context_for({{unit}}, number_), MessageKind::inherit, context_, x_term, {}, {},
                     number_);
  }
  if (context_->is_nonempty) tell_nominal_all(unit.predicate());
}

bool Worker::is_context_of(std::uint32_t nominal) const {
  const auto& core = context_->key.core;
  return core.size() == 1 && core[0] == unary(nominal, x_term);
}

//  true -> {a}(x), true -> A(x) in v    v exists
//  ---------------------------------------------
//  true -> A(x) in a*
void Worker::tell_nominal(std::uint32_t nominal, Literal unit) {
  if (is_context_of(nominal) || unit == unary(nominal, x_term)) return;
  saturation_.post(saturation_.context_for({{unary(nominal, x_term)}}, number_), MessageKind::fact, context_, x_term,
                   {}, std::span(&unit, 1), number_);
}

void Worker::tell_nominal_all(std::uint32_t nominal) {
  if (is_context_of(nominal)) return;
  context_->store.for_each_unit([&](Literal unit) {
    if (unit.term() == x_term) tell_nominal(nominal, unit);
  });
}

//  true -> A(x) in a*    true -> {a}(x) in v
//  -----------------------------------------
//  true -> A(x) in v
//
// What a* derives by itself v derives, too. What a* was told is passed on.
void Worker::receive_fact(Literal fact) {
  if (context_->is_unsatisfiable || context_->store.has(fact, ClauseStore::unit)) return;
  units_.push_back(fact);
  context_->facts.push_back(fact);
  for (Context* const inheritor : context_->inheritors) {
    saturation_.post(*inheritor, MessageKind::fact, context_, x_term, {}, std::span(&fact, 1), number_);
  }
}

void Worker::receive_inheritor(Context* inheritor) {
  if (context_->is_unsatisfiable) {
    // Nothing is {a}, so nothing is in that context.
    return saturation_.post(*inheritor, MessageKind::clause, context_, x_term, {}, {}, number_);
  }
  context_->inheritors.push_back(inheritor);
  for (const Literal& fact : context_->facts) {
    saturation_.post(*inheritor, MessageKind::fact, context_, x_term, {}, std::span(&fact, 1), number_);
  }
}

void Worker::receive_existence() {
  Context& self = *context_;
  if (self.is_nonempty) return;
  self.is_nonempty = true;
  if (self.is_unsatisfiable) return saturation_.contradict();
  for (const std::uint32_t nominal : self.nominals) tell_nominal_all(nominal);
  for (Successor& successor : self.successors) tell_existence(successor);
}

//  u exists    <u, v, f>    something about f(x) has an empty body
//  ---------------------------------------------------------------
//  v exists
void Worker::tell_existence(Successor& successor) {
  if (!context_->is_nonempty || !successor.is_certain || successor.target == nullptr) return;
  if (successor.knows_existence) return;
  successor.knows_existence = true;
  saturation_.post(*successor.target, MessageKind::exists, context_, successor.f, {}, {}, number_);
}

}  // namespace geminga::consequence
