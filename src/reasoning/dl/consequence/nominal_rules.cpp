#include "reasoning/dl/consequence/nominal_rules.hpp"

#include <span>

namespace geminga::consequence {
namespace {

[[nodiscard]] bool is_context_of(const Context& context, std::uint32_t nominal) {
  const auto& core = context.key.core;
  return core.size() == 1 && core[0] == unary(nominal, x_term);
}

}  // namespace

void NominalRules::apply(Context& context, Literal unit) {
  if (unit.kind() == LiteralKind::unary && rules_.is_nominal(unit.predicate())) apply_nominal(context, unit);
  if (unit.term() != x_term || !context.is_nonempty) return;
  for (const std::uint32_t nominal : context.nominal_links.nominals) tell(context, nominal, unit);
}

void NominalRules::apply_nominal(Context& context, Literal unit) {
  //  true -> {a}(s)    true -> {a}(t)
  //  --------------------------------
  //  true -> s = t
  std::uint32_t& first = context.store.number_of(nominal_key(unit.predicate()));
  if (first == 0) {
    first = static_cast<std::uint32_t>(unit.term()) + 1;
  } else if (const Term known{first - 1}; known != unit.term()) {
    conclusions_.add_unit(equality(known, unit.term(), false));
  }
  if (unit.term() != x_term) return;
  context.nominal_links.nominals.push_back(unit.predicate());
  if (!is_context_of(context, unit.predicate())) {
    outbox_.send(outbox_.context_for({{unit}}), MessageKind::inherit, &context, x_term);
  }
  if (context.is_nonempty) tell_all(context, unit.predicate());
}

//  true -> {a}(x), true -> A(x) in v    v exists
//  ---------------------------------------------
//  true -> A(x) in a*
void NominalRules::tell(Context& context, std::uint32_t nominal, Literal unit) {
  if (is_context_of(context, nominal) || unit == unary(nominal, x_term)) return;
  outbox_.send(outbox_.context_for({{unary(nominal, x_term)}}), MessageKind::fact, &context, x_term, {},
               std::span(&unit, 1));
}

void NominalRules::tell_all(Context& context, std::uint32_t nominal) {
  if (is_context_of(context, nominal)) return;
  context.store.for_each_unit([&](Literal unit) {
    if (unit.term() == x_term) tell(context, nominal, unit);
  });
}

void NominalRules::tell_all(Context& context) {
  for (const std::uint32_t nominal : context.nominal_links.nominals) tell_all(context, nominal);
}

//  true -> A(x) in a*    true -> {a}(x) in v
//  -----------------------------------------
//  true -> A(x) in v
//
// v derives by itself all that a* derives by itself. Only the facts that a* was told are passed on.
void NominalRules::receive_fact(Context& context, Literal fact) {
  if (context.is_unsatisfiable || context.store.has(fact, ClauseStore::unit)) return;
  conclusions_.add_unit(fact);
  context.nominal_links.facts.push_back(fact);
  for (Context* const inheritor : context.nominal_links.inheritors) {
    outbox_.send(*inheritor, MessageKind::fact, &context, x_term, {}, std::span(&fact, 1));
  }
}

void NominalRules::receive_inheritor(Context& context, Context& inheritor) {
  if (context.is_unsatisfiable) return outbox_.send(inheritor, MessageKind::clause, &context, x_term);
  context.nominal_links.inheritors.push_back(&inheritor);
  for (const Literal& fact : context.nominal_links.facts) {
    outbox_.send(inheritor, MessageKind::fact, &context, x_term, {}, std::span(&fact, 1));
  }
}

void NominalRules::tell_unsatisfiable(Context& context) {
  for (Context* const inheritor : context.nominal_links.inheritors) {
    outbox_.send(*inheritor, MessageKind::clause, &context, x_term);
  }
}

}  // namespace geminga::consequence
