// The limits of a model check.
#ifndef GEMINGA_REASONING_EL_MODEL_LIMITS_HPP
#define GEMINGA_REASONING_EL_MODEL_LIMITS_HPP

#include <cstddef>

#include "base/budget.hpp"

namespace geminga::el {

/// The most that is looked at of successor contexts (successor_contexts.hpp). Beyond it the check fails for all
/// classes, and the other engines decide.
struct SuccessorLimits {
  std::size_t contexts = std::size_t{1} << 23;
  std::size_t lessons = std::size_t{1} << 25;  ///< that one successor context teaches another
  std::size_t grown = 64;                      ///< expressions that one grows by; beyond it that one fails
  base::Budget* budget = nullptr;              ///< borrowed
};

}  // namespace geminga::el

#endif
