#include "discovery/roles/holders.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "discovery/roles/matching.hpp"
#include "discovery/roles/pool.hpp"
#include "discovery/roles/search.hpp"

namespace geminga::roles {
namespace {

/// Whether all who may be chosen cost the same in each role, so that each choice costs as much.
bool has_equal_costs(const Pool& pool) {
  std::vector<std::set<Cost>> costs(pool.counts.size());
  for (const Candidate& robot : pool.robots) {
    for (const Holding& one : robot.shared) costs[one.role].insert(one.cost);
    for (const Holding& one : robot.alone) costs[one.role].insert(one.cost);
  }
  return std::ranges::all_of(costs, [](const auto& of_role) { return of_role.size() <= 1; });
}

void measure(const Task& task, Holders& result) {
  std::vector<bool> is_there(task.robots);
  for (std::size_t role = 0; role < result.of_role.size(); ++role) {
    for (const std::uint32_t robot : result.of_role[role]) {
      is_there[robot] = true;
      result.cost += std::ranges::find(task.roles[role].suited, robot, &Suited::robot)->cost;
      if (!task.former.empty() && !std::ranges::binary_search(task.former[role], robot)) ++result.changes;
    }
  }
  result.robots = static_cast<std::size_t>(std::ranges::count(is_there, true));
}

}  // namespace

Holders best_holders(const Task& task, std::size_t steps) {
  if (!task.is_within_limits()) return {.verdict = Holders::Verdict::too_large};
  const auto pool = pool_of_fewest_changes(task);
  if (!pool) return {};
  Steps left{.left = steps};
  auto filling = fewest_robots(*pool, left);
  if (!filling) return {};
  if (!has_equal_costs(*pool)) filling = cheapest_robots(*pool, std::move(*filling), left);
  Holders result{.verdict = left.are_used_up ? Holders::Verdict::good : Holders::Verdict::best,
                 .of_role = std::move(filling->of_role)};
  for (auto& holders : result.of_role) std::ranges::sort(holders);
  measure(task, result);
  return result;
}

std::vector<std::uint32_t> shortage(const Task& task) {
  std::vector<std::uint32_t> lacking(task.roles.size());
  if (!task.is_within_limits()) return lacking;
  std::vector<std::size_t> places;
  for (std::size_t role = 0; role < task.roles.size(); ++role) {
    const Role& one = task.roles[role];
    if (!one.is_shared) places.insert(places.end(), one.count, role);
    const auto suited = static_cast<std::uint32_t>(one.suited.size());
    if (one.is_shared) lacking[role] = one.count - std::min(one.count, suited);
  }
  if (places.empty()) return lacking;
  // Behind the robots stand as many imagined ones, who can do everything and are taken last.
  const std::size_t robots = task.robots + places.size();
  std::vector<Cost> costs(places.size() * robots, forbidden);
  for (std::size_t place = 0; place < places.size(); ++place) {
    for (const Suited& one : task.roles[places[place]].suited) costs[place * robots + one.robot] = 0;
    for (std::size_t at = task.robots; at < robots; ++at) costs[place * robots + at] = 1;
  }
  const auto found = cheapest_matching(places.size(), robots, costs);
  for (std::size_t place = 0; found && place < places.size(); ++place) {
    if (found->robot_of[place] >= task.robots) ++lacking[places[place]];
  }
  return lacking;
}

}  // namespace geminga::roles
