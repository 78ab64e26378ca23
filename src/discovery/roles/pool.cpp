#include "discovery/roles/pool.hpp"

#include <algorithm>
#include <utility>

namespace geminga::roles {
namespace {

/// More than all holdings of a task cost.
constexpr Cost cost_of_unbound = Cost{1} << 40;
static_assert(Cost{max_holders} * max_cost < cost_of_unbound && max_holders * cost_of_unbound < forbidden / 2);

/// By role and then as the robots that suit it: what is to be as little as can be, before anything else counts.
using FirstCosts = std::vector<std::vector<Cost>>;

/// Those who cost less than the last holder needed hold a shared role in any case, and those who cost as much are
/// chosen among.
void add_shared(const Role& role, std::uint32_t number, const std::vector<Cost>& first, Pool& pool) {
  std::vector<Cost> sorted = first;
  std::ranges::nth_element(sorted, sorted.begin() + (role.count - 1));
  const Cost last = sorted[role.count - 1];
  for (std::size_t at = 0; at < role.suited.size(); ++at) {
    const Suited& one = role.suited[at];
    if (first[at] < last) {
      pool.settled[number].push_back(one.robot);
      pool.robots[one.robot].is_needed = true;
      --pool.counts[number];
    } else if (first[at] == last) {
      pool.robots[one.robot].shared.push_back({number, one.cost});
    }
  }
}

/// Lets robots hold what they hold in some cheapest matching: that is where an optimal price is met exactly, and a
/// robot that has a price is in each such matching (complementary slackness). False if there is none.
bool add_alone(const Task& task, const FirstCosts& first, Pool& pool) {
  const auto places = pool.roles_of_places();
  const auto is_free = [&](std::uint32_t role) {
    return std::ranges::count(first[role], 0) == std::ssize(first[role]);
  };
  if (std::ranges::all_of(places, is_free)) {  // any matching will do
    for (std::size_t place = 0; place < places.size(); ++place) {
      if (place > 0 && places[place - 1] == places[place]) continue;
      for (const Suited& one : task.roles[places[place]].suited) {
        pool.robots[one.robot].alone.push_back({places[place], one.cost});
      }
    }
    return true;
  }
  std::vector<Cost> costs(places.size() * task.robots, forbidden);
  for (std::size_t place = 0; place < places.size(); ++place) {
    const auto& suited = task.roles[places[place]].suited;
    for (std::size_t at = 0; at < suited.size(); ++at) {
      costs[place * task.robots + suited[at].robot] = first[places[place]][at];
    }
  }
  const auto found = cheapest_matching(places.size(), task.robots, costs);
  if (!found) return false;
  for (std::size_t place = 0; place < places.size(); ++place) {
    const std::uint32_t role = places[place];
    if (place > 0 && places[place - 1] == role) continue;
    for (const Suited& one : task.roles[role].suited) {
      const Cost price = found->price_of_place[place] + found->price_of_robot[one.robot];
      if (costs[place * task.robots + one.robot] == price) pool.robots[one.robot].alone.push_back({role, one.cost});
    }
  }
  for (std::uint32_t robot = 0; robot < task.robots; ++robot) {
    Candidate& one = pool.robots[robot];
    one.is_bound = found->price_of_robot[robot] < 0;
    one.is_needed = one.is_needed || one.is_bound;
  }
  return true;
}

std::optional<Pool> pool_by(const Task& task, const FirstCosts& first) {
  Pool pool;
  pool.robots.resize(task.robots);
  pool.settled.resize(task.roles.size());
  for (const Role& role : task.roles) {
    pool.counts.push_back(role.count);
    pool.is_shared.push_back(role.is_shared);
    if (!role.is_shared) pool.places += role.count;
    if (role.suited.size() < role.count) return std::nullopt;
  }
  for (std::uint32_t role = 0; role < task.roles.size(); ++role) {
    if (pool.is_shared[role] && pool.counts[role] > 0) add_shared(task.roles[role], role, first[role], pool);
  }
  if (pool.places > 0 && !add_alone(task, first, pool)) return std::nullopt;
  return pool;
}

}  // namespace

std::size_t Filling::robots() const { return static_cast<std::size_t>(std::ranges::count(is_there, true)); }

std::vector<std::uint32_t> Pool::roles_of_places() const {
  std::vector<std::uint32_t> all;
  for (std::uint32_t role = 0; role < counts.size(); ++role) {
    if (!is_shared[role]) all.insert(all.end(), counts[role], role);
  }
  return all;
}

std::optional<Pool> pool_of_fewest_changes(const Task& task) {
  FirstCosts changes;
  for (std::size_t role = 0; role < task.roles.size(); ++role) {
    auto& of_role = changes.emplace_back();
    for (const Suited& one : task.roles[role].suited) {
      const bool is_new = !task.former.empty() && !std::ranges::binary_search(task.former[role], one.robot);
      of_role.push_back(is_new ? 1 : 0);
    }
  }
  return pool_by(task, changes);
}

std::optional<Pool> pool_of_least_cost(const Task& task) {
  FirstCosts costs;
  for (const Role& role : task.roles) {
    auto& of_role = costs.emplace_back();
    for (const Suited& one : role.suited) of_role.push_back(one.cost);
  }
  return pool_by(task, costs);
}

std::optional<Filling> Pool::fill(const std::vector<bool>& chosen) const {
  Filling filling{.of_role = settled, .is_there = chosen};
  std::vector<std::uint32_t> there;
  std::vector<std::vector<std::pair<Cost, std::uint32_t>>> able(counts.size());
  for (std::uint32_t robot = 0; robot < chosen.size(); ++robot) {
    if (!chosen[robot]) continue;
    there.push_back(robot);
    for (const Holding& one : robots[robot].shared) able[one.role].emplace_back(one.cost, robot);
  }
  if (places > there.size()) return std::nullopt;
  for (std::size_t role = 0; role < counts.size(); ++role) {
    if (!is_shared[role]) continue;
    if (able[role].size() < counts[role]) return std::nullopt;
    std::ranges::sort(able[role]);
    for (std::size_t at = 0; at < counts[role]; ++at) {
      filling.cost += able[role][at].first;
      filling.of_role[role].push_back(able[role][at].second);
    }
  }
  if (places == 0) return filling;
  // Those who are bound are taken first.
  std::vector<std::size_t> first(counts.size());
  const auto role_of = roles_of_places();
  for (std::size_t place = places; place-- > 0;) first[role_of[place]] = place;
  std::vector<Cost> costs(places * there.size(), forbidden);
  Cost unbound = static_cast<Cost>(places);
  for (std::size_t at = 0; at < there.size(); ++at) {
    const Candidate& robot = robots[there[at]];
    if (robot.is_bound) --unbound;
    for (const Holding& one : robot.alone) {
      for (std::size_t place = first[one.role]; place < first[one.role] + counts[one.role]; ++place) {
        costs[place * there.size() + at] = one.cost + (robot.is_bound ? 0 : cost_of_unbound);
      }
    }
  }
  const auto found = cheapest_matching(places, there.size(), costs);
  if (!found || found->cost / cost_of_unbound != unbound) return std::nullopt;
  filling.cost += found->cost % cost_of_unbound;
  for (std::size_t place = 0; place < places; ++place) {
    filling.of_role[role_of[place]].push_back(there[found->robot_of[place]]);
  }
  return filling;
}

}  // namespace geminga::roles
