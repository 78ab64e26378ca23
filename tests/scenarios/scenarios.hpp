// The named scenarios: what happens to teams of robots out there.
#ifndef GEMINGA_TESTS_SCENARIOS_SCENARIOS_HPP
#define GEMINGA_TESTS_SCENARIOS_SCENARIOS_HPP

#include <span>
#include <string_view>

#include "scenarios/conditions.hpp"

namespace geminga::scenarios {

struct Scenario {
  std::string_view name;
  std::string_view summary;
  Conditions conditions;
};

/// In the order of their names.
[[nodiscard]] std::span<const Scenario> all_scenarios();
/// Null: there is none of that name.
[[nodiscard]] const Scenario* find_scenario(std::string_view name);

}  // namespace geminga::scenarios

#endif
