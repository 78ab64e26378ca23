// The limits of a classification.
#ifndef GEMINGA_REASONING_EL_LIMITS_HPP
#define GEMINGA_REASONING_EL_LIMITS_HPP

#include <cstddef>
#include <optional>

#include "reasoning/el/closure/limits.hpp"
#include "reasoning/el/model/limits.hpp"

namespace geminga::el {

/// Where one is reached, less may be found, and the axioms that were not used are named.
struct ClassifyLimits {
  /// Of conclusions; beyond it the ontology is refused. By default it grows with the axioms.
  std::optional<std::size_t> conclusions;
  std::size_t merged_atoms = default_max_merged_atoms;
  /// Classes that are saturated once more with an instance, for nominals. Beyond it nominals are left out.
  std::size_t worlds = 20'000;
  unsigned rounds_of_inverses = 8;  ///< a conclusion from inverses may lead to others
  unsigned rounds_of_unions = 8;    ///< a superclass of one union may lead to superclasses of others
  SuccessorLimits successors{};
};

}  // namespace geminga::el

#endif
