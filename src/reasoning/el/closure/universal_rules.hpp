// The rules of a saturation for universals: they narrow the successors of a context.
//
// A narrowed successor has a context of several atoms together, as merged successors of functional properties have. A
// link that was made to the wider context stays; it says less.
#ifndef GEMINGA_REASONING_EL_CLOSURE_UNIVERSAL_RULES_HPP
#define GEMINGA_REASONING_EL_CLOSURE_UNIVERSAL_RULES_HPP

#include <cstdint>

#include "reasoning/el/closure/conclusions.hpp"

namespace geminga::el {

class UniversalRules {
 public:
  explicit UniversalRules(Conclusions& conclusions)
      : conclusions_(conclusions), contexts_(conclusions.contexts()), index_(conclusions.index()) {}

  /// The context at the end of a told link, narrowed by the universals that the context is known to have.
  [[nodiscard]] std::uint32_t successor_of(std::uint32_t context, const LinkRule& link);
  /// Draws the conclusions of a new subsumer that has universals.
  void apply(std::uint32_t context, ExprId subsumer);
  /// Draws the conclusions of `R Self` in a context.
  void apply_to_self(std::uint32_t context, RoleId role);

 private:
  Conclusions& conclusions_;
  ContextStore& contexts_;
  const IndexedOntology& index_;
};

}  // namespace geminga::el

#endif
