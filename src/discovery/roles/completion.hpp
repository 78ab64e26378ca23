// Completion of a task that nobody can do: the least that would have to be added.
#ifndef GEMINGA_DISCOVERY_ROLES_COMPLETION_HPP
#define GEMINGA_DISCOVERY_ROLES_COMPLETION_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "discovery/roles/holders.hpp"
#include "discovery/roles/task.hpp"

namespace geminga::roles {

/// The most that one robot may lack for a role; more counts as much.
inline constexpr std::uint32_t max_missing = 255;

struct Completion {
  std::vector<std::vector<std::uint32_t>> of_role{};  ///< robots, ascending
  std::vector<std::uint32_t> lacking{};               ///< by role: holders that no robot can be, whatever is added
  std::uint64_t missing = 0;                          ///< of all holders of `of_role` together
};

/// Holders for a task whose costs say how much a robot lacks for a role (0: it suits it), and which has no robot that
/// can never suit. As few holders as can be are lacking, then as little as can be is missing, counted for each role of
/// a robot: both without a search. Then the robots are as few as the steps can tell. Former holders are not looked at.
/// Nothing for a task beyond the limits of task.hpp.
[[nodiscard]] std::optional<Completion> least_completion(const Task& task, std::size_t steps = usual_steps);

}  // namespace geminga::roles

#endif
