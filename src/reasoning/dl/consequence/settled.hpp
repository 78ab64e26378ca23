// Which contexts no gap matters to, so that what is known of them is complete in a consistent ontology.
//
// Let O be consistent, with a model I. Where nothing that is open (a nominal, a range of values that is not understood;
// see RuleSet::is_open) stands in the head of any clause of the contexts that a context leads to, the calculus
// builds from these contexts a model J of all rules in which nothing open holds of anything: the literals that hold in
// J are literals of such heads (Bate et al., section 6). In J no thing is an individual, so that neither facts nor keys
// speak of J, and each value has only ranges whose common values are known. As the body of a rule hangs together by its
// roles, I and J beside each other are a model of O. So what does not hold in J does not follow from O.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_SETTLED_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_SETTLED_HPP

#include <span>
#include <string>
#include <vector>

#include "reasoning/dl/consequence/saturation.hpp"

namespace geminga::consequence {

class Settled {
 public:
  /// Of a saturation that has run. `gaps` are those of the closure: with one that is not about facts, keys, nominals or
  /// ranges nothing is settled, as it may matter everywhere.
  Settled(const Saturation& saturation, std::span<const std::string> gaps);

  [[nodiscard]] bool is_settled(const Context& context) const { return !is_open_[context.number]; }

 private:
  void find_open(const Saturation& saturation);

  std::vector<bool> is_open_;  ///< by number of the context
};

}  // namespace geminga::consequence

#endif
