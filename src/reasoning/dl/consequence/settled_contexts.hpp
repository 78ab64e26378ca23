// Settled contexts: no gap matters to them, so that all their subsumers are known if the ontology is consistent.
//
// Let O be consistent, with a model I. A predicate is open if it is a nominal or a range of values that is not
// understood; see RuleSet::is_open. Take a context that leads only to contexts whose clauses have no open predicate in
// their heads. From these the calculus builds a model J of all rules in which no open predicate holds of anything,
// because the literals that hold in J occur in such heads (Bate et al., section 6). No thing of J is an individual, so
// facts, keys and rules do not concern J, and each value of J has only ranges whose common values are known. The atoms
// of a rule's body are connected by roles, so I and J side by side are a model of O. Hence what does not hold in J does
// not follow from O.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_SETTLED_CONTEXTS_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_SETTLED_CONTEXTS_HPP

#include <span>
#include <string>
#include <vector>

#include "reasoning/dl/consequence/saturation.hpp"

namespace geminga::consequence {

/// The contexts of a saturation that are settled.
class SettledContexts {
 public:
  /// For a saturation that has run. `gaps` are those of the closure. If one of them is not about facts, keys, rules,
  /// nominals or ranges, it may matter everywhere, and no context is settled.
  SettledContexts(const Saturation& saturation, std::span<const std::string> gaps);

  [[nodiscard]] bool is_settled(const Context& context) const { return !is_open_[context.number]; }

 private:
  void find_open(const Saturation& saturation);

  std::vector<bool> is_open_;  ///< by number of the context
};

}  // namespace geminga::consequence

#endif
