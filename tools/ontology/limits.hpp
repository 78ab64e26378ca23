// How long and how hard a command may search: --time-limit and --steps.
#ifndef GEMINGA_ONTOLOGY_LIMITS_HPP
#define GEMINGA_ONTOLOGY_LIMITS_HPP

#include <chrono>
#include <cstdint>
#include <string>

#include "base/budget.hpp"

namespace CLI {
class App;
}

namespace geminga::ontology {

/// Of one run. Where a limit is reached, what is settled by then is printed and used, and the exit status is 4.
struct WorkLimits {
  /// Beyond what the ontologies that people publish need; one engine takes 2 to 20 million steps in a second.
  static constexpr std::uint64_t default_steps = 2'000'000'000;

  unsigned seconds = 0;  ///< by the clock, from the start of the program; 0: none
  std::uint64_t steps = default_steps;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

/// Adds both to a command.
void add_work_limits(CLI::App& command, WorkLimits& limits);

/// What may be spent. Only searches ask it; what must be done in any case, as reading, is ended by limit_time().
[[nodiscard]] base::Budget budget_of(const WorkLimits& limits);

}  // namespace geminga::ontology

#endif
