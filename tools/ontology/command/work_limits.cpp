#include "ontology/command/work_limits.hpp"

namespace geminga::ontology {

base::Budget budget_of(const WorkLimits& limits) {
  if (limits.seconds == 0) return base::Budget(limits.steps);
  const auto end = limits.start + std::chrono::seconds(limits.seconds);
  return base::Budget(limits.steps, [end] { return std::chrono::steady_clock::now() >= end; });
}

}  // namespace geminga::ontology
