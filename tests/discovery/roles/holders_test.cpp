// Holders of roles: as good as the best of all choices, on random tasks and at the limits.
#include "discovery/roles/holders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/random.hpp"
#include "discovery/roles/pool.hpp"
#include "support/rounds.hpp"

namespace geminga::roles {
namespace {

using Chosen = std::vector<std::vector<std::uint32_t>>;
using Score = std::tuple<std::size_t, std::size_t, std::uint64_t>;  ///< changes, robots, cost

/// Whether everybody suits, is counted once in a role, and holds one role at most that is not shared.
bool is_allowed(const Task& task, const Chosen& chosen) {
  std::set<std::uint32_t> alone;
  if (chosen.size() != task.roles.size()) return false;
  for (std::size_t role = 0; role < chosen.size(); ++role) {
    const std::set<std::uint32_t> holders(chosen[role].begin(), chosen[role].end());
    if (holders.size() != task.roles[role].count || holders.size() != chosen[role].size()) return false;
    for (const std::uint32_t robot : holders) {
      const auto& suited = task.roles[role].suited;
      if (std::ranges::find(suited, robot, &Suited::robot) == suited.end()) return false;
      if (!task.roles[role].is_shared && !alone.insert(robot).second) return false;
    }
  }
  return true;
}

Score score(const Task& task, const Chosen& chosen) {
  std::set<std::uint32_t> robots;
  std::size_t changes = 0;
  std::uint64_t cost = 0;
  for (std::size_t role = 0; role < chosen.size(); ++role) {
    for (const std::uint32_t robot : chosen[role]) {
      robots.insert(robot);
      cost += std::ranges::find(task.roles[role].suited, robot, &Suited::robot)->cost;
      if (!task.former.empty() && !std::ranges::binary_search(task.former[role], robot)) ++changes;
    }
  }
  return {changes, robots.size(), cost};
}

/// The best of all choices, each of which is tried.
std::optional<Score> by_brute_force(const Task& task) {
  std::optional<Score> best;
  Chosen chosen(task.roles.size());
  const std::function<void(std::size_t, std::size_t)> choose = [&](std::size_t role, std::size_t from) {
    if (role == task.roles.size()) {
      if (is_allowed(task, chosen) && (!best || score(task, chosen) < *best)) best = score(task, chosen);
      return;
    }
    const auto& suited = task.roles[role].suited;
    if (chosen[role].size() == task.roles[role].count) return choose(role + 1, 0);
    for (std::size_t at = from; at < suited.size(); ++at) {
      chosen[role].push_back(suited[at].robot);
      choose(role, at + 1);
      chosen[role].pop_back();
    }
  };
  choose(0, 0);
  return best;
}

Task random_task(base::Random& random) {
  Task task{.robots = static_cast<std::uint32_t>(1 + random.below(7)), .roles = {}, .former = {}};
  const std::uint64_t roles = 1 + random.below(4);
  const bool has_costs = random.chance(0.5);
  for (std::uint64_t at = 0; at < roles; ++at) {
    Role role{.count = static_cast<std::uint32_t>(random.below(3)), .is_shared = random.chance(0.5), .suited = {}};
    for (std::uint32_t robot = 0; robot < task.robots; ++robot) {
      const auto cost = static_cast<std::uint32_t>(has_costs ? random.below(4) : 0);
      if (random.chance(0.6)) role.suited.push_back({robot, cost});
    }
    task.roles.push_back(std::move(role));
  }
  return task;
}

TEST(Holders, AreAsGoodAsTheBestOfAllChoicesOfRandomTasks) {
  int done = 0;
  int impossible = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(400U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    base::Random random(seed);
    Task task = random_task(random);
    for (int turn = 0; turn < 2; ++turn) {  // anew, and then with somebody gone
      const auto expected = by_brute_force(task);
      const Holders found = best_holders(task);
      ASSERT_EQ(found.verdict, expected ? Holders::Verdict::best : Holders::Verdict::nobody);
      const auto lacking = shortage(task);
      ASSERT_EQ(std::ranges::all_of(lacking, [](std::uint32_t one) { return one == 0; }), expected.has_value());
      if (!expected) {
        ++impossible;
        break;
      }
      ++done;
      ASSERT_TRUE(is_allowed(task, found.of_role));
      ASSERT_EQ(score(task, found.of_role), *expected);
      ASSERT_EQ((Score{found.changes, found.robots, found.cost}), *expected);
      task.former = found.of_role;
      const auto gone = static_cast<std::uint32_t>(random.below(task.robots));
      for (Role& role : task.roles) std::erase_if(role.suited, [&](const Suited& one) { return one.robot == gone; });
    }
  }
  EXPECT_GT(done, 0);
  EXPECT_GT(impossible, 0);
}

/// Twelve robots, some of them equal; a robot that suits more roles costs more in half of the tasks.
Task wide_task(base::Random& random) {
  Task task{.robots = 12, .roles = {}, .former = {}};
  const std::uint64_t kinds = 3 + random.below(10);
  const bool is_correlated = random.chance(0.5);
  const bool has_kinds_of_cost = random.chance(0.5);
  std::vector<std::uint64_t> kind;
  std::vector<std::uint32_t> cost;
  for (std::uint32_t robot = 0; robot < task.robots; ++robot) {
    kind.push_back(random.below(kinds));
    cost.push_back(static_cast<std::uint32_t>(random.below(12)));
  }
  std::vector<std::uint32_t> suited(task.robots);
  for (std::uint64_t at = 0; at < 6; ++at) {
    Role role{.count = static_cast<std::uint32_t>(1 + random.below(3)), .is_shared = random.chance(0.7), .suited = {}};
    std::vector<bool> suits;
    for (std::uint64_t one = 0; one < kinds; ++one) suits.push_back(random.chance(0.5));
    for (std::uint32_t robot = 0; robot < task.robots; ++robot) {
      if (!suits[kind[robot]]) continue;
      ++suited[robot];
      role.suited.push_back({robot, has_kinds_of_cost ? static_cast<std::uint32_t>(kind[robot]) : cost[robot]});
    }
    task.roles.push_back(std::move(role));
  }
  for (Role& role : task.roles) {
    for (Suited& one : role.suited) one.cost += is_correlated ? 3 * suited[one.robot] : 0;
  }
  return task;
}

TEST(Holders, AreAsGoodAsThoseOfTheBestOfAllSetsOfRobots) {
  for (std::uint64_t seed = 1; seed <= test::rounds(20U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    base::Random random(seed);
    const Task task = wide_task(random);
    const auto pool = pool_of_fewest_changes(task);
    std::optional<std::pair<std::size_t, Cost>> best;
    for (std::uint32_t set = 0; pool && set < 1U << task.robots; ++set) {
      std::vector<bool> robots;
      for (std::uint32_t robot = 0; robot < task.robots; ++robot) robots.push_back((set >> robot & 1U) != 0);
      const auto filling = pool->fill(robots);
      if (filling && (!best || std::pair(filling->robots(), filling->cost) < *best)) {
        best.emplace(filling->robots(), filling->cost);
      }
    }
    const Holders found = best_holders(task);
    ASSERT_EQ(found.verdict, best ? Holders::Verdict::best : Holders::Verdict::nobody);
    if (!best) continue;
    EXPECT_TRUE(is_allowed(task, found.of_role));
    EXPECT_EQ(found.robots, best->first);
    EXPECT_EQ(static_cast<Cost>(found.cost), best->second);
  }
}

TEST(Holders, KeepTheirRolesWhereSomebodyFails) {
  // 0 does both; when it fails, 1 and 2 each do one, and 3 would do both.
  Task task{.robots = 4, .roles = {}, .former = {}};
  task.roles.push_back({.count = 1, .is_shared = true, .suited = {{0}, {1}, {3}}});
  task.roles.push_back({.count = 1, .is_shared = true, .suited = {{0}, {2}, {3}}});
  EXPECT_EQ(best_holders(task).of_role, (Chosen{{0}, {0}}));
  task.former = {{0}, {2}};
  std::erase_if(task.roles[0].suited, [](const Suited& one) { return one.robot == 0; });
  const Holders kept = best_holders(task);
  EXPECT_EQ(kept.of_role[1], (std::vector<std::uint32_t>{2})) << "though 3 alone would do";
  EXPECT_EQ(kept.changes, 1U);
  EXPECT_EQ(kept.robots, 2U);
}

TEST(Holders, SayWhereTheSearchEndedEarly) {
  base::Random random(7);
  Task task{.robots = 40, .roles = {}, .former = {}};
  for (int at = 0; at < 20; ++at) {
    Role role{.count = 1, .is_shared = true, .suited = {}};
    for (std::uint32_t robot = 0; robot < task.robots; ++robot) {
      if (random.chance(0.15)) role.suited.push_back({robot, static_cast<std::uint32_t>(random.below(9))});
    }
    task.roles.push_back(std::move(role));
  }
  const Holders best = best_holders(task);
  EXPECT_EQ(best.verdict, Holders::Verdict::best);
  for (const std::size_t steps : {0U, 1U, 10U, 40U}) {
    const Holders early = best_holders(task, steps);
    EXPECT_EQ(early.verdict, Holders::Verdict::good) << steps;
    EXPECT_TRUE(is_allowed(task, early.of_role)) << steps;
    EXPECT_GE((Score{early.changes, early.robots, early.cost}), (Score{best.changes, best.robots, best.cost}));
  }
}

TEST(Holders, RefuseATaskBeyondTheLimits) {
  const auto verdict = [](std::uint32_t robots, std::size_t roles, std::uint32_t count) {
    Task task{.robots = robots, .roles = {}, .former = {}};
    for (std::size_t at = 0; at < roles; ++at) task.roles.push_back({.count = count, .is_shared = true, .suited = {}});
    return best_holders(task).verdict;
  };
  using Verdict = Holders::Verdict;
  EXPECT_EQ(verdict(max_robots - 1, 1, 1), Verdict::nobody);
  EXPECT_EQ(verdict(max_robots, 1, 1), Verdict::nobody);
  EXPECT_EQ(verdict(max_robots + 1, 1, 1), Verdict::too_large);
  EXPECT_EQ(verdict(1, max_roles - 1, 1), Verdict::nobody);
  EXPECT_EQ(verdict(1, max_roles, 1), Verdict::nobody);
  EXPECT_EQ(verdict(1, max_roles + 1, 1), Verdict::too_large);
  EXPECT_EQ(verdict(1, 1, max_holders - 1), Verdict::nobody);
  EXPECT_EQ(verdict(1, 1, max_holders), Verdict::nobody);
  EXPECT_EQ(verdict(1, 1, max_holders + 1), Verdict::too_large);
}

}  // namespace
}  // namespace geminga::roles
