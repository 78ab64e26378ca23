// The named limits of a classification.
#ifndef GEMINGA_REASONING_EL_LIMITS_HPP
#define GEMINGA_REASONING_EL_LIMITS_HPP

#include <cstddef>
#include <optional>

#include "base/budget.hpp"

namespace geminga::el {

/// Of what functional properties merge. Beyond it they are left out and named.
inline constexpr std::size_t default_max_merged_atoms = std::size_t{1} << 20;

/// The most that may be derived. What is beyond it ends the run; what was derived by then follows.
struct SaturationLimits {
  std::size_t conclusions = std::size_t{1} << 31;  ///< bounds the work and with it the memory
  /// Atoms of all contexts that are of some together. Merging the successors of functional properties can need
  /// exponentially many of them: ELF, EL with functional properties, is complete for exponential time.
  std::size_t merged_atoms = default_max_merged_atoms;
  base::Budget* budget = nullptr;  ///< what the work may cost: work_count.hpp; borrowed
};

/// The most that is looked at of what successors learn through inverses (copies.hpp). Beyond it nothing is known of any
/// class, and the ontology is left to the engines that are not bound to the form of EL.
struct CopyLimits {
  std::size_t copies = std::size_t{1} << 23;
  std::size_t lessons = std::size_t{1} << 25;  ///< of copies by copies
  std::size_t grown = 64;          ///< expressions by which one copy grows; beyond it nothing is known of it
  base::Budget* budget = nullptr;  ///< borrowed
};

/// Where one is reached, less may be found, and what was not used is named.
struct ClassifyLimits {
  /// Nothing: it grows with the axioms (default_conclusions()). Beyond it the ontology is refused.
  std::optional<std::size_t> conclusions;
  std::size_t merged_atoms = default_max_merged_atoms;
  /// Classes that are saturated once more with an instance, for what nominals say. Beyond it these are left out.
  std::size_t worlds = 20'000;
  unsigned rounds_of_inverses = 8;  ///< what copies learn may let others learn more
  unsigned rounds_of_unions = 8;    ///< what one union is found to be in may show what others are in
  CopyLimits copies{};
};

}  // namespace geminga::el

#endif
