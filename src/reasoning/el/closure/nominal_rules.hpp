// The rules of a saturation for nominals: contexts below an individual, and contexts that must have an instance.
#ifndef GEMINGA_REASONING_EL_CLOSURE_NOMINAL_RULES_HPP
#define GEMINGA_REASONING_EL_CLOSURE_NOMINAL_RULES_HPP

#include <cstdint>

#include "reasoning/el/closure/conclusions.hpp"

namespace geminga::el {

/// One thread applies these rules alone, because they reach into other contexts.
class NominalRules {
 public:
  explicit NominalRules(Conclusions& conclusions)
      : conclusions_(conclusions), contexts_(conclusions.contexts()), index_(conclusions.index()) {}

  /// Draws the conclusions of a new subsumer.
  void apply(std::uint32_t context, ExprId subsumer);
  /// Draws the conclusions of a new link, which both ends may know to be from an individual to itself.
  void apply_to_link(std::uint32_t from, RoleId role, std::uint32_t to);
  /// States that the context, and all that its links lead to, have instances in every model.
  void require_nonempty(std::uint32_t context);

 private:
  /// True if the instances of the context are values.
  [[nodiscard]] bool is_of_values(std::uint32_t context) const;
  void merge_into_nominal(std::uint32_t context, std::uint32_t nominal);
  void find_selfs(std::uint32_t context, std::uint32_t nominal);

  Conclusions& conclusions_;
  ContextStore& contexts_;
  const IndexedOntology& index_;
};

}  // namespace geminga::el

#endif
