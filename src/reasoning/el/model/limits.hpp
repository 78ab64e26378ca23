// The limits of conclusions from inverses.
#ifndef GEMINGA_REASONING_EL_MODEL_LIMITS_HPP
#define GEMINGA_REASONING_EL_MODEL_LIMITS_HPP

#include <cstddef>

#include "base/budget.hpp"

namespace geminga::el {

/// The most that is looked at of successor contexts (inverse_conclusions.hpp). Beyond it less is concluded.
struct SuccessorLimits {
  std::size_t contexts = std::size_t{1} << 23;
  std::size_t grown = 64;          ///< expressions that one successor context is in beyond its context
  base::Budget* budget = nullptr;  ///< borrowed
};

}  // namespace geminga::el

#endif
