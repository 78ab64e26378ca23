#include "discovery/roles/holders.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "discovery/roles/matching.hpp"

namespace geminga::roles {
namespace {

// One number orders choices: changes, then robots, then costs, none of which can carry into the next by the limits of
// task.hpp.
constexpr Cost cost_of_robot = Cost{1} << 34;
constexpr Cost cost_of_change = Cost{1} << 46;
static_assert(Cost{max_holders} * max_cost < cost_of_robot);
static_assert(Cost{max_robots} * cost_of_robot <= cost_of_change && max_holders * cost_of_change < forbidden);

struct Candidate {
  std::uint32_t robot = 0;
  Cost cost = 0;
};

class HoldersSearch {
 public:
  HoldersSearch(const Task& task, std::size_t steps)
      : task_(task), steps_left_(steps), is_chosen_(task.robots), is_matched_(task.robots), kind_(task.robots) {
    for (std::size_t role = 0; role < task.roles.size(); ++role) {
      candidates_.push_back(candidates_of(role));
      if (!task.roles[role].is_shared) places_.insert(places_.end(), task.roles[role].count, role);
    }
    find_kinds();
    open_.resize(task.roles.size());
    for (std::size_t role = 0; role < task.roles.size(); ++role) {
      open_[role].is_barred.resize(task.robots);
      open_[role].is_open = task.roles[role].is_shared;
    }
  }

  Holders run() {
    if (!match()) return {};
    visit(0);
    Holders result;
    if (!best_) {
      result.verdict = is_stopped_ ? Holders::Verdict::unknown : Holders::Verdict::nobody;
      return result;
    }
    result.verdict = is_stopped_ ? Holders::Verdict::good : Holders::Verdict::best;
    result.of_role = *best_;
    measure(result);
    return result;
  }

 private:
  struct Open {
    bool is_open = false;
    std::vector<std::uint32_t> held{};
    std::vector<bool> is_barred{};  ///< by robot: held, or tried already
    Cost cost = 0;                  ///< of those that hold it
  };

  std::vector<Candidate> candidates_of(std::size_t role) const {
    std::vector<Candidate> all;
    for (const Suited& one : task_.roles[role].suited) {
      const bool is_new = !task_.former.empty() && !std::ranges::binary_search(task_.former[role], one.robot);
      all.push_back({one.robot, one.cost + (is_new ? cost_of_change : 0)});
    }
    std::ranges::sort(all, {}, [](const Candidate& one) { return std::pair(one.cost, one.robot); });
    return all;
  }

  /// Robots of one kind suit the same roles at the same costs, so that either may stand for the other.
  void find_kinds() {
    std::vector<std::vector<std::pair<std::size_t, Cost>>> suits(task_.robots);
    for (std::size_t role = 0; role < candidates_.size(); ++role) {
      for (const Candidate& one : candidates_[role]) suits[one.robot].emplace_back(role, one.cost);
    }
    auto different = suits;
    std::ranges::sort(different);
    for (std::uint32_t robot = 0; robot < task_.robots; ++robot) {
      kind_[robot] = std::ranges::lower_bound(different, suits[robot]) - different.begin();
    }
  }

  /// Fills the places of roles that are not shared; chosen robots cost nothing more. False if they cannot be filled.
  bool match() {
    is_matched_.assign(task_.robots, false);
    total_ = std::accumulate(is_chosen_.begin(), is_chosen_.end(), Cost{0}) * cost_of_robot;
    matched_.clear();
    if (places_.empty()) return true;
    std::vector<Cost> costs(places_.size() * task_.robots, forbidden);
    for (std::size_t place = 0; place < places_.size(); ++place) {
      for (const Candidate& one : candidates_[places_[place]]) {
        costs[place * task_.robots + one.robot] = one.cost + (is_chosen_[one.robot] ? 0 : cost_of_robot);
      }
    }
    const auto found = cheapest_matching(places_.size(), task_.robots, costs);
    if (!found) return false;
    matched_ = found->robot_of;
    for (const std::uint32_t robot : matched_) is_matched_[robot] = true;
    total_ += found->cost;
    return true;
  }

  /// The part of a role that is open: the cheapest way to fill it, and how many of these would be new robots.
  struct Rest {
    bool is_possible = false;
    Cost cost = 0;
    std::vector<std::uint32_t> chosen{};  ///< where chosen robots do as well as any
    std::size_t new_robots = 0;
    std::size_t slack = 0;
  };
  Rest rest_of(std::size_t role) const {
    const Open& open = open_[role];
    const std::size_t needed = task_.roles[role].count - open.held.size();
    Rest rest;
    Cost by_chosen = 0;
    std::size_t count = 0;
    for (const Candidate& one : candidates_[role]) {
      if (open.is_barred[one.robot]) continue;
      if (count++ < needed) rest.cost += one.cost;
      if (is_chosen_[one.robot] && rest.chosen.size() < needed) {
        rest.chosen.push_back(one.robot);
        by_chosen += one.cost;
      }
    }
    rest.is_possible = count >= needed;
    rest.slack = count - std::min(count, needed);
    rest.new_robots = needed - rest.chosen.size();
    if (rest.new_robots != 0 || by_chosen != rest.cost) rest.chosen.clear();
    return rest;
  }

  /// The fewest robots that the open roles need beyond those that are chosen: each robot gives a role at most one
  /// holder, and pays the same part of itself for each role that it may help.
  std::size_t robots_to_come(const std::vector<std::pair<std::size_t, Rest>>& rests) const {
    std::vector<std::uint32_t> helps(task_.robots);
    const auto for_each_new = [&](std::size_t role, const auto& take) {
      for (const Candidate& one : candidates_[role]) {
        if (!is_chosen_[one.robot] && !open_[role].is_barred[one.robot]) take(one.robot);
      }
    };
    for (const auto& [role, rest] : rests) {
      if (rest.new_robots > 0) for_each_new(role, [&](std::uint32_t robot) { ++helps[robot]; });
    }
    double parts = 0;
    for (const auto& [role, rest] : rests) {
      if (rest.new_robots == 0) continue;
      std::uint32_t most = 1;
      for_each_new(role, [&](std::uint32_t robot) { most = std::max(most, helps[robot]); });
      parts += static_cast<double>(rest.new_robots) / most;
    }
    return static_cast<std::size_t>(std::ceil(parts - 1e-9));
  }

  /// `spent` is the cost of the roles that are closed.
  void visit(Cost spent) {
    if (is_stopped_ || steps_left_ == 0) {
      is_stopped_ = true;
      return;
    }
    --steps_left_;
    std::vector<std::size_t> closed;
    std::vector<std::pair<std::size_t, Rest>> rests;
    bool is_possible = true;
    Cost least = 0;
    for (std::size_t role = 0; role < open_.size() && is_possible; ++role) {
      Open& open = open_[role];
      if (!open.is_open) continue;
      Rest rest = rest_of(role);
      is_possible = rest.is_possible;
      if (rest.chosen.size() + open.held.size() == task_.roles[role].count) {
        spent += open.cost + rest.cost;
        open.is_open = false;
        closing_.emplace_back(role, std::move(rest.chosen));
        closed.push_back(role);
        continue;
      }
      least += open.cost + rest.cost;
      rests.emplace_back(role, std::move(rest));
    }
    if (is_possible && bound(rests) + spent + least < best_cost_) {
      if (rests.empty()) {
        keep(spent);
      } else {
        branch(spent, rests);
      }
    }
    for (const std::size_t role : closed) open_[role].is_open = true;
    closing_.resize(closing_.size() - closed.size());
  }

  /// The least that robots and places can still come to.
  Cost bound(const std::vector<std::pair<std::size_t, Rest>>& rests) const {
    const auto chosen = static_cast<std::size_t>(std::ranges::count(is_chosen_, true));
    const auto robots = static_cast<Cost>(chosen + robots_to_come(rests));
    return std::max(total_, total_ / cost_of_change * cost_of_change + robots * cost_of_robot);
  }

  void branch(Cost spent, const std::vector<std::pair<std::size_t, Rest>>& rests) {
    const auto tightest = std::ranges::min_element(rests, {}, [](const auto& one) { return one.second.slack; });
    const std::size_t role = tightest->first;
    Open& open = open_[role];
    std::vector<std::uint32_t> helps(task_.robots);
    for (const auto& [other, rest] : rests) {
      for (const Candidate& one : candidates_[other]) ++helps[one.robot];
    }
    std::vector<Candidate> order;
    for (const Candidate& one : candidates_[role]) {
      if (!open.is_barred[one.robot]) order.push_back(one);
    }
    std::ranges::sort(order, {}, [&](const Candidate& one) {
      const bool is_there = is_chosen_[one.robot] || is_matched_[one.robot];
      return std::tuple(one.cost + (is_there ? 0 : cost_of_robot), -std::int64_t{helps[one.robot]}, one.robot);
    });
    std::size_t left = order.size();
    std::vector<std::uint32_t> tried;
    for (const Candidate& one : order) {
      if (left-- < task_.roles[role].count - open.held.size()) break;
      if (!std::ranges::any_of(tried, [&](std::uint32_t other) { return is_same(one.robot, other, role); })) {
        hold(role, one, spent);
      }
      tried.push_back(one.robot);
      open.is_barred[one.robot] = true;
    }
    for (const std::uint32_t robot : tried) open.is_barred[robot] = false;
  }

  /// Whether a robot can do here nothing but what another could that was tried in its place.
  bool is_same(std::uint32_t robot, std::uint32_t tried, std::size_t here) const {
    if (kind_[robot] != kind_[tried] || is_chosen_[robot] || is_chosen_[tried]) return false;
    for (std::size_t role = 0; role < open_.size(); ++role) {
      const bool is_alike = role == here || open_[role].is_barred[robot] == open_[role].is_barred[tried];
      if (!is_alike) return false;
    }
    return true;
  }

  void hold(std::size_t role, const Candidate& one, Cost spent) {
    Open& open = open_[role];
    const bool is_new = !is_chosen_[one.robot];
    const bool is_rematched = is_new && !is_matched_[one.robot];
    const auto matched = matched_;
    const auto is_matched = is_matched_;
    const Cost total = total_;
    open.held.push_back(one.robot);
    open.is_barred[one.robot] = true;
    open.cost += one.cost;
    is_chosen_[one.robot] = true;
    if (!is_rematched || match()) visit(spent);
    is_chosen_[one.robot] = !is_new;
    open.cost -= one.cost;
    open.is_barred[one.robot] = false;
    open.held.pop_back();
    matched_ = matched;
    is_matched_ = is_matched;
    total_ = total;
  }

  /// All roles are closed, and this is better than all before.
  void keep(Cost spent) {
    best_cost_ = total_ + spent;
    best_.emplace(task_.roles.size());
    for (std::size_t place = 0; place < places_.size(); ++place) (*best_)[places_[place]].push_back(matched_[place]);
    for (std::size_t role = 0; role < open_.size(); ++role) {
      (*best_)[role].insert((*best_)[role].end(), open_[role].held.begin(), open_[role].held.end());
    }
    for (const auto& [role, robots] : closing_) {
      (*best_)[role].insert((*best_)[role].end(), robots.begin(), robots.end());
    }
    for (auto& holders : *best_) std::ranges::sort(holders);
  }

  void measure(Holders& result) const {
    std::vector<bool> is_there(task_.robots);
    for (std::size_t role = 0; role < result.of_role.size(); ++role) {
      for (const std::uint32_t robot : result.of_role[role]) {
        is_there[robot] = true;
        const auto one = std::ranges::find(task_.roles[role].suited, robot, &Suited::robot);
        result.cost += one->cost;
        const bool is_new = !task_.former.empty() && !std::ranges::binary_search(task_.former[role], robot);
        if (is_new) ++result.changes;
      }
    }
    result.robots = static_cast<std::size_t>(std::ranges::count(is_there, true));
  }

  const Task& task_;
  std::size_t steps_left_;
  bool is_stopped_ = false;
  std::vector<std::vector<Candidate>> candidates_;  ///< by role, the cheapest first
  std::vector<std::size_t> places_;                 ///< of roles that are not shared: the role
  std::vector<bool> is_chosen_;                     ///< by robot: it holds a shared role
  std::vector<bool> is_matched_;                    ///< by robot: it has a place
  std::vector<std::uint32_t> matched_;              ///< by place
  Cost total_ = 0;                                  ///< of all chosen and matched robots, and of the places
  std::vector<std::ptrdiff_t> kind_;                ///< by robot
  std::vector<Open> open_;                          ///< by role
  std::vector<std::pair<std::size_t, std::vector<std::uint32_t>>> closing_;  ///< holders of closed roles
  Cost best_cost_ = forbidden;
  std::optional<std::vector<std::vector<std::uint32_t>>> best_;
};

}  // namespace

Holders best_holders(const Task& task, std::size_t steps) {
  if (!task.is_within_limits()) return {.verdict = Holders::Verdict::too_large};
  return HoldersSearch(task, steps).run();
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
