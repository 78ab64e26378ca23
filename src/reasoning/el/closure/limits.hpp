// The limits of a closure.
#ifndef GEMINGA_REASONING_EL_CLOSURE_LIMITS_HPP
#define GEMINGA_REASONING_EL_CLOSURE_LIMITS_HPP

#include <cstddef>

#include "base/budget.hpp"

namespace geminga::el {

/// The limit of merged atoms. Beyond it functional properties are left out and named.
inline constexpr std::size_t default_max_merged_atoms = std::size_t{1} << 20;

/// The most that may be derived. A run ends at a limit; what was derived by then follows.
struct SaturationLimits {
  std::size_t conclusions = std::size_t{1} << 31;  ///< bounds the work and with it the memory
  /// Atoms of all contexts of several atoms. Merging the successors of functional properties can need exponentially
  /// many of them: ELF, EL with functional properties, is complete for exponential time.
  std::size_t merged_atoms = default_max_merged_atoms;
  base::Budget* budget = nullptr;  ///< of the work (work_count.hpp); borrowed
};

}  // namespace geminga::el

#endif
