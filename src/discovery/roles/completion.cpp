#include "discovery/roles/completion.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "discovery/roles/pool.hpp"
#include "discovery/roles/search.hpp"

namespace geminga::roles {

std::optional<Completion> least_completion(const Task& task, std::size_t steps) {
  if (!task.is_within_limits()) return std::nullopt;
  // Robots that can be anything stand for holders that are lacking, as many as there must be, each dearer than all
  // else.
  const auto short_of = shortage(task);
  const std::uint32_t imagined = std::accumulate(short_of.begin(), short_of.end(), 0U);
  Task filled{.robots = task.robots + imagined, .roles = task.roles, .former = {}};
  Cost all_missing = 1;
  for (Role& role : filled.roles) {
    std::uint32_t most = 0;
    for (Suited& one : role.suited) most = std::max(most, one.cost = std::min(one.cost, max_missing));
    all_missing += Cost{role.count} * most;
  }
  for (Role& role : filled.roles) {
    for (std::uint32_t at = 0; at < imagined; ++at) {
      role.suited.push_back({task.robots + at, static_cast<std::uint32_t>(all_missing)});
    }
  }
  const auto pool = pool_of_least_cost(filled);
  if (!pool) return std::nullopt;
  Steps left{.left = steps};
  const auto filling = fewest_robots(*pool, left);
  if (!filling) return std::nullopt;
  Completion result{.of_role = filling->of_role, .lacking = {}};
  for (std::size_t role = 0; role < result.of_role.size(); ++role) {
    auto& holders = result.of_role[role];
    result.lacking.push_back(
        static_cast<std::uint32_t>(std::erase_if(holders, [&](std::uint32_t robot) { return robot >= task.robots; })));
    std::ranges::sort(holders);
    for (const std::uint32_t robot : holders) {
      result.missing += std::ranges::find(filled.roles[role].suited, robot, &Suited::robot)->cost;
    }
  }
  return result;
}

}  // namespace geminga::roles
