// Rules for nominals. They are sound and cheap, and complete for facts without alternatives.
//
// A context exists if some thing is certain to be in it: the context of an individual, the one with an empty core, and
// those of the certain successors of a context that exists. Legend: {a} the nominal of a, t s terms, a* the context of
// {a}.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_NOMINAL_RULES_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_NOMINAL_RULES_HPP

#include <cstdint>

#include "reasoning/dl/consequence/conclusions.hpp"
#include "reasoning/dl/consequence/context.hpp"
#include "reasoning/dl/consequence/outbox.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"

namespace geminga::consequence {

/// Of a context, NominalRules reads the units, files keys in the store, and changes the nominal links.
class NominalRules {
 public:
  NominalRules(const Rules& rules, Conclusions& conclusions, Outbox& outbox)
      : rules_(rules), conclusions_(conclusions), outbox_(outbox) {}

  /// Applies the rules to a processed unit.
  void apply(Context& context, Literal unit);
  /// Tells the nominals of a context that has come to exist all its units.
  void tell_all(Context& context);
  // Messages of other contexts.
  void receive_fact(Context& context, Literal fact);
  void receive_inheritor(Context& context, Context& inheritor);
  /// Tells the inheritors that nothing is {a}, and so nothing is in them.
  void tell_unsatisfiable(Context& context);

 private:
  void apply_nominal(Context& context, Literal unit);
  void tell(Context& context, std::uint32_t nominal, Literal unit);
  void tell_all(Context& context, std::uint32_t nominal);

  const Rules& rules_;
  Conclusions& conclusions_;
  Outbox& outbox_;
};

}  // namespace geminga::consequence

#endif
