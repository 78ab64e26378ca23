// The context of each successor, and the hypotheses that it is told.
//
//  G -> D v [A] in u; f(x) is in A
//  --------------------------------------------------------------- Succ [K1: the L of Su with true -> L f in u]
//  <u, v, f> for a v with core(v) part of K1                            [K2: those with G -> D v [L f] in u]
//  L -> L in v for each L of K2 that is not in core(v)
//
// K1's concepts are the core ("eager" in the paper). So what certainly holds of a successor is a unit in its context,
// and a Horn ontology has units nearly everywhere. The successor's roles to x are not in the core, so that equal
// successors of different roles share one context, as in EL. A successor that is not certain to exist has a context of
// its function.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_SUCCESSOR_RULE_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_SUCCESSOR_RULE_HPP

#include <vector>

#include "reasoning/dl/consequence/context.hpp"
#include "reasoning/dl/consequence/outbox.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"

namespace geminga::consequence {

/// Of a context, SuccessorRule changes only the successor that it is given.
class SuccessorRule {
 public:
  SuccessorRule(const Rules& rules, Outbox& outbox) : rules_(rules), outbox_(outbox) {}

  /// Applies Succ to a successor of the context that has changed.
  void apply(Context& context, Successor& successor);
  /// Tells the successor's context that it exists, once:
  ///
  ///  u exists    <u, v, f>    something about f(x) has an empty body
  ///  ---------------------------------------------------------------
  ///  v exists
  void tell_existence(Context& context, Successor& successor);

 private:
  const Rules& rules_;
  Outbox& outbox_;
  std::vector<Literal> hypotheses_;  ///< room for those of a message
};

}  // namespace geminga::consequence

#endif
