// Completion of tasks that nobody can do: as little as the least of all choices of random tasks, and at the limits.
#include "discovery/roles/completion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/random.hpp"
#include "support/rounds.hpp"

namespace geminga::roles {
namespace {

using Partly = std::vector<std::vector<std::uint32_t>>;
using Lack = std::tuple<std::size_t, std::uint64_t, std::size_t>;  ///< holders, missing, robots

Lack lack_of(const Task& task, const Partly& chosen) {
  std::size_t holders = 0;
  std::uint64_t missing = 0;
  std::set<std::uint32_t> robots;
  for (std::size_t role = 0; role < chosen.size(); ++role) {
    holders += task.roles[role].count - chosen[role].size();
    for (const std::uint32_t robot : chosen[role]) {
      robots.insert(robot);
      missing += std::ranges::find(task.roles[role].suited, robot, &Suited::robot)->cost;
    }
  }
  return {holders, missing, robots.size()};
}

/// The least of all choices, each of which is tried, those that leave a role short as well.
Lack least_by_brute_force(const Task& task) {
  Partly chosen(task.roles.size());
  Lack least = lack_of(task, chosen);
  std::set<std::uint32_t> alone;
  const std::function<void(std::size_t, std::size_t)> choose = [&](std::size_t role, std::size_t from) {
    if (role == task.roles.size()) {
      least = std::min(least, lack_of(task, chosen));
      return;
    }
    choose(role + 1, 0);
    if (chosen[role].size() == task.roles[role].count) return;
    const Role& one = task.roles[role];
    for (std::size_t at = from; at < one.suited.size(); ++at) {
      const std::uint32_t robot = one.suited[at].robot;
      if (!one.is_shared && !alone.insert(robot).second) continue;
      chosen[role].push_back(robot);
      choose(role, at + 1);
      chosen[role].pop_back();
      if (!one.is_shared) alone.erase(robot);
    }
  };
  choose(0, 0);
  return least;
}

TEST(Completion, IsTheLeastOfAllChoicesOfRandomTasks) {
  int short_ones = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(200U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    base::Random random(seed);
    Task task{.robots = static_cast<std::uint32_t>(1 + random.below(5)), .roles = {}, .former = {}};
    const std::uint64_t roles = 1 + random.below(4);
    for (std::uint64_t at = 0; at < roles; ++at) {
      Role role{.count = static_cast<std::uint32_t>(random.below(3)), .is_shared = random.chance(0.5), .suited = {}};
      for (std::uint32_t robot = 0; robot < task.robots; ++robot) {
        if (random.chance(0.6)) role.suited.push_back({robot, static_cast<std::uint32_t>(random.below(4))});
      }
      task.roles.push_back(std::move(role));
    }
    const auto found = least_completion(task);
    ASSERT_TRUE(found);
    const Lack lack = lack_of(task, found->of_role);
    EXPECT_EQ(lack, least_by_brute_force(task));
    EXPECT_EQ(std::get<0>(lack), std::accumulate(found->lacking.begin(), found->lacking.end(), 0U));
    EXPECT_EQ(std::get<1>(lack), found->missing);
    if (std::get<0>(lack) > 0) ++short_ones;
  }
  EXPECT_GT(short_ones, 0);
}

TEST(Completion, CountsNoMoreThanTheLimitForARobotAndARole) {
  for (const std::uint32_t missing : {max_missing - 1, max_missing, max_missing + 1}) {
    const Task task{.robots = 1, .roles = {{.count = 1, .is_shared = false, .suited = {{0, missing}}}}, .former = {}};
    const auto found = least_completion(task);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->missing, std::min(missing, max_missing));
  }
  EXPECT_FALSE(least_completion({.robots = max_robots + 1, .roles = {}, .former = {}}));
}

}  // namespace
}  // namespace geminga::roles
