#include "discovery/roles/search.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "discovery/roles/decisions.hpp"
#include "discovery/roles/gathering.hpp"
#include "discovery/roles/prices.hpp"

namespace geminga::roles {
namespace {

/// Turns of the prices before the search branches. Measured on the families of tests/bench/roles_bench.cpp.
constexpr int turns_at_first = 300;
constexpr int turns_of_branch = 10;
constexpr int matchings_at_first = 5;
/// The first step of the prices, in parts of the whole way, and the turns without a better bound that halve it.
constexpr Cost whole_way = 256;
constexpr int patience = 10;

/// Branch and bound over the robots: prices of the roles bound each branch and say what must be decided in it, and whom
/// they choose or a matching takes is tried as a choice.
class Search {
 public:
  /// A choice costs its holdings, and `cost_of_robot` for each robot, of which it has at most `most`.
  Search(const Pool& pool, Cost cost_of_robot, std::size_t most, Filling first, Steps& steps)
      : pool_(pool),
        cost_of_robot_(cost_of_robot),
        steps_(steps),
        decisions_(pool, most),
        prices_(pool, cost_of_robot),
        best_(std::move(first)),
        best_cost_(cost_of(best_)) {}

  Filling run() {
    prices_.bound(decisions_);
    if (pool_.places > 0 && cost_of_robot_ == 0 && !try_matches(matchings_at_first)) return std::move(best_);
    visit(turns_at_first);
    return std::move(best_);
  }

 private:
  using State = Decisions::State;

  [[nodiscard]] Cost cost_of(const Filling& filling) const {
    return filling.cost + cost_of_robot_ * static_cast<Cost>(filling.robots());
  }
  /// Whether a bound leaves nothing better than what is known.
  [[nodiscard]] bool is_beaten(Cost bound) const { return bound > (best_cost_ - 1) * Prices::unit; }

  void try_robots(const std::vector<bool>& robots) {
    if (robots == tried_ || static_cast<std::size_t>(std::ranges::count(robots, true)) > decisions_.most()) return;
    tried_ = robots;
    auto filling = pool_.fill(robots);
    if (!filling || cost_of(*filling) >= best_cost_) return;
    best_cost_ = cost_of(*filling);
    best_ = std::move(*filling);
  }

  /// Tries those with the best values who help.
  void try_best_values() {
    std::vector<std::uint32_t> order;
    for (std::uint32_t robot = 0; robot < pool_.robots.size(); ++robot) {
      if (decisions_[robot] == State::open) order.push_back(robot);
    }
    std::ranges::sort(order, {}, [&](std::uint32_t robot) { return std::pair(prices_.values()[robot], robot); });
    const auto robots = gather(pool_, decisions_.robots_in(), order);
    if (!robots.empty()) try_robots(robots);
  }

  /// Some turns by matchings. False if nothing better is left.
  bool try_matches(int turns) {
    auto best_prices = prices_.of_roles();
    Cost best_bound = -forbidden;
    prices_.stand();
    for (int turn = 0; turn < turns; ++turn) {
      const auto match = prices_.match(decisions_);
      if (!match.is_possible) return false;
      try_robots(match.robots);
      if (is_beaten(match.bound)) return false;
      if (match.bound > best_bound) {
        best_bound = match.bound;
        best_prices = prices_.of_roles();
      }
      if (!prices_.move(std::max(best_cost_ * Prices::unit - match.bound, Prices::unit / 8), whole_way)) break;
    }
    prices_.set(best_prices);
    return true;
  }

  /// Looks at the decisions as they are. Undoes all that it decides.
  void visit(int turns) {
    if (steps_.are_used_up) return;
    const auto mark = decisions_.mark();
    const auto prices = prices_.of_roles();
    if (const auto robot = improve(turns)) branch(*robot);
    decisions_.undo(mark);
    prices_.set(prices);
  }

  /// Improves prices and what is known, and decides what follows. Returns the robot to branch on, if anything is open.
  std::optional<std::size_t> improve(int turns) {
    std::vector<int> times_chosen(pool_.robots.size());
    auto best_prices = prices_.of_roles();
    Cost best_bound = -forbidden;
    Cost part = whole_way;
    int fruitless = 0;
    int turn = 0;
    bool is_best = false;
    if (turns != turns_at_first && cost_of_robot_ == 0 && pool_.places == decisions_.most()) {
      prices_.bound(decisions_);
      if (!try_matches(1)) return std::nullopt;
      prices_.set(best_prices);
    }
    prices_.stand();
    for (; turn < turns && part > 0 && !is_best && !decisions_.is_complete(); ++turn) {
      if (steps_.left == 0) {
        steps_.are_used_up = true;
        return std::nullopt;
      }
      --steps_.left;
      const Cost bound = prices_.bound(decisions_);
      for (std::size_t robot = 0; robot < times_chosen.size(); ++robot) times_chosen[robot] += prices_.chosen()[robot];
      if (!try_choices(turn, turns) || is_beaten(bound)) return std::nullopt;
      if (cost_of_robot_ > 0 && best_cost_ <= static_cast<Cost>(pool_.places)) return std::nullopt;
      if (!decide_forced(bound)) return std::nullopt;
      if (bound > best_bound) {
        best_bound = bound;
        best_prices = prices_.of_roles();
        fruitless = 0;
      } else if (++fruitless == patience) {
        fruitless = 0;
        part /= 2;
        prices_.set(best_prices);
        prices_.stand();
      }
      is_best = !prices_.move(std::max(best_cost_ * Prices::unit - bound, Prices::unit / 8), part);
    }
    prices_.set(std::move(best_prices));
    if (decisions_.is_complete()) {
      try_robots(decisions_.robots_in());
      return std::nullopt;
    }
    return least_settled(times_chosen, turn);
  }

  /// False if nothing better is left.
  bool try_choices(int turn, int turns) {
    const bool is_first = turns == turns_at_first;
    if (is_first ? turn % 8 == 0 : turn == turns - 1) {
      try_best_values();
    } else if (prices_.fills_all()) {
      try_robots(prices_.chosen());
    }
    return true;
  }

  bool decide_forced(Cost bound) {
    const auto forced = prices_.forced(decisions_, (best_cost_ - 1) * Prices::unit - bound);
    return std::ranges::all_of(forced, [&](const auto& one) { return decisions_.decide(one.first, one.second); });
  }

  /// The robot that was chosen about as often as not.
  [[nodiscard]] std::size_t least_settled(const std::vector<int>& times_chosen, int turns) {
    std::size_t least = pool_.robots.size();
    const auto rank = [&](std::size_t robot) {
      return std::pair(std::abs(2 * times_chosen[robot] - turns), prices_.values()[robot]);
    };
    for (std::size_t robot = 0; robot < pool_.robots.size(); ++robot) {
      if (decisions_[robot] == State::open && (least == pool_.robots.size() || rank(robot) < rank(least)))
        least = robot;
    }
    is_mostly_chosen_ = 2 * times_chosen[least] >= turns;
    return least;
  }

  void branch(std::size_t robot) {
    const bool is_in_first = is_mostly_chosen_;
    for (const bool is_in : {is_in_first, !is_in_first}) {
      const auto mark = decisions_.mark();
      if (decisions_.decide(robot, is_in ? State::in : State::out)) visit(turns_of_branch);
      decisions_.undo(mark);
    }
  }

  const Pool& pool_;
  Cost cost_of_robot_;
  Steps& steps_;
  Decisions decisions_;
  Prices prices_;
  Filling best_;
  Cost best_cost_;
  std::vector<bool> tried_{};
  bool is_mostly_chosen_ = false;
};

/// A choice that needs no search: robots in the order of their numbers, as far as they help.
std::optional<Filling> first_filling(const Pool& pool) {
  std::vector<bool> needed;
  std::vector<std::uint32_t> others;
  for (std::uint32_t robot = 0; robot < pool.robots.size(); ++robot) {
    needed.push_back(pool.robots[robot].is_needed);
    if (!needed.back()) others.push_back(robot);
  }
  const auto helpful = gather(pool, needed, others);
  return pool.fill(helpful.empty() ? needed : helpful);
}

}  // namespace

std::optional<Filling> fewest_robots(const Pool& pool, Steps& steps) {
  Pool equal = pool;
  for (Candidate& robot : equal.robots) {
    for (Holding& one : robot.shared) one.cost = 0;
    for (Holding& one : robot.alone) one.cost = 0;
  }
  auto first = first_filling(equal);
  if (!first) return std::nullopt;
  const Filling fewest = Search(equal, 1, pool.robots.size(), std::move(*first), steps).run();
  return pool.fill(fewest.is_there);
}

Filling cheapest_robots(const Pool& pool, Filling filling, Steps& steps) {
  const std::size_t most = filling.robots();
  return Search(pool, 0, most, std::move(filling), steps).run();
}

}  // namespace geminga::roles
