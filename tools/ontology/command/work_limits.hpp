// The limits of a search: time by the clock, and counted steps.
#ifndef GEMINGA_ONTOLOGY_COMMAND_WORK_LIMITS_HPP
#define GEMINGA_ONTOLOGY_COMMAND_WORK_LIMITS_HPP

#include <chrono>
#include <cstdint>

#include "base/budget.hpp"

namespace geminga::ontology {

/// The limits of one run. Where one is reached, what is settled by then is printed and used, and the exit status is 4.
struct WorkLimits {
  /// More than published ontologies need; one engine takes 2 to 20 million steps in a second.
  static constexpr std::uint64_t default_steps = 2'000'000'000;

  unsigned seconds = 0;  ///< from the start of the program; 0: no limit
  std::uint64_t steps = default_steps;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

/// The budget of a search within these limits. Reading asks no budget; limit_time() ends it.
[[nodiscard]] base::Budget budget_of(const WorkLimits& limits);

}  // namespace geminga::ontology

#endif
