#include "discovery/roles/prices.hpp"

#include <algorithm>
#include <limits>

namespace geminga::roles {
namespace {

constexpr auto no_place = std::numeric_limits<std::uint32_t>::max();
/// Keeps sums of prices within 64 bits, far above what any role is worth.
constexpr Cost max_price = Cost{1} << 40;
constexpr Cost max_step = Cost{1} << 40;
/// The part of a former direction that goes into the next one, out of 16. Measured: 12 needs the fewest steps.
constexpr Cost kept_direction = 12;
/// Directions count in 256th of a holder.
constexpr Cost holder = 256;
/// Is added to each cost of a matching, where none may be negative.
constexpr Cost offset = Cost{1} << 52;
/// Is taken from the cost of each robot that is bound, so that it gets a place rather than others.
constexpr Cost bonus_of_bound = Cost{1} << 47;

}  // namespace

Prices::Prices(const Pool& pool, Cost cost_of_robot)
    : pool_(pool),
      cost_of_robot_(cost_of_robot),
      prices_(pool.counts.size()),
      direction_(pool.counts.size()),
      short_of_(pool.counts.size()),
      values_(pool.robots.size()),
      place_of_(pool.robots.size(), no_place),
      chosen_(pool.robots.size()) {
  std::vector<std::vector<Cost>> costs(pool.counts.size());
  std::size_t most_holdings = 1;
  for (const Candidate& robot : pool.robots) {
    most_holdings = std::max(most_holdings, robot.shared.size() + (robot.alone.empty() ? 0 : 1));
    for (const Holding& one : robot.shared) costs[one.role].push_back(one.cost);
    for (const Holding& one : robot.alone) costs[one.role].push_back(one.cost);
  }
  for (std::size_t role = 0; role < costs.size(); ++role) {
    const std::size_t count = pool.counts[role];
    if (count == 0) continue;
    std::ranges::nth_element(costs[role], costs[role].begin() + static_cast<std::ptrdiff_t>(count - 1));
    prices_[role] = costs[role][count - 1] * unit + cost_of_robot * unit / static_cast<Cost>(most_holdings);
  }
}

Cost Prices::gain_of_shared(const Candidate& robot) const {
  Cost gain = 0;
  for (const Holding& one : robot.shared) gain += std::min<Cost>(0, one.cost * unit - prices_[one.role]);
  return gain;
}

bool Prices::needs_place(std::size_t robot, const Decisions& decisions) const {
  return pool_.robots[robot].is_bound || pool_.places == decisions.most();
}

Cost Prices::bound(const Decisions& decisions) {
  Cost total = 0;
  for (std::size_t role = 0; role < prices_.size(); ++role) {
    short_of_[role] = pool_.counts[role];
    total += prices_[role] * short_of_[role];
  }
  free_.clear();
  for (std::size_t robot = 0; robot < values_.size(); ++robot) {
    chosen_[robot] = decisions[robot] == Decisions::State::in;
    if (decisions[robot] == Decisions::State::out) continue;
    const Candidate& one = pool_.robots[robot];
    Cost place = needs_place(robot, decisions) ? forbidden : 0;
    place_of_[robot] = no_place;
    for (const Holding& held : one.alone) {
      const Cost cost = held.cost * unit - prices_[held.role];
      if (cost >= place) continue;
      place = cost;
      place_of_[robot] = held.role;
    }
    values_[robot] = cost_of_robot_ * unit + gain_of_shared(one) + place;
    if (!chosen_[robot]) free_.push_back(robot);
  }
  const auto room = static_cast<std::ptrdiff_t>(std::min(decisions.room(), free_.size()));
  const auto is_better = [&](std::size_t one, std::size_t other) {
    return values_[one] != values_[other] ? values_[one] < values_[other] : one < other;
  };
  if (free_.begin() + room != free_.end()) std::ranges::nth_element(free_, free_.begin() + room, is_better);
  taken_ = static_cast<std::size_t>(room);
  if (cost_of_robot_ > 0) {
    const auto pays = [&](std::size_t robot) { return values_[robot] < 0; };
    taken_ = static_cast<std::size_t>(std::partition(free_.begin(), free_.begin() + room, pays) - free_.begin());
  }
  for (std::size_t at = 0; at < taken_; ++at) chosen_[free_[at]] = true;
  for (std::size_t robot = 0; robot < values_.size(); ++robot) {
    if (!chosen_[robot]) continue;
    total += values_[robot];
    for (const Holding& one : pool_.robots[robot].shared) {
      if (one.cost * unit < prices_[one.role]) --short_of_[one.role];
    }
    if (place_of_[robot] != no_place) --short_of_[place_of_[robot]];
  }
  return total;
}

bool Prices::fills_all() const {
  return std::ranges::all_of(short_of_, [](Cost lacking) { return lacking <= 0; });
}

std::vector<std::pair<std::size_t, Decisions::State>> Prices::forced(const Decisions& decisions, Cost gap) const {
  const bool is_full = taken_ == decisions.room();
  const bool must_be_full = cost_of_robot_ == 0 && pool_.places == decisions.most();
  Cost worst_taken = -forbidden;
  for (std::size_t at = 0; at < taken_; ++at) worst_taken = std::max(worst_taken, values_[free_[at]]);
  Cost best_left = must_be_full ? forbidden : 0;
  if (is_full) {
    for (std::size_t at = taken_; at < free_.size(); ++at) best_left = std::min(best_left, values_[free_[at]]);
  }
  std::vector<std::pair<std::size_t, Decisions::State>> all;
  for (std::size_t at = 0; at < free_.size(); ++at) {
    const Cost value = values_[free_[at]];
    if (at < taken_ && best_left - value > gap) all.emplace_back(free_[at], Decisions::State::in);
    if (at >= taken_ && value - (is_full ? worst_taken : 0) > gap) all.emplace_back(free_[at], Decisions::State::out);
  }
  return all;
}

bool Prices::move(Cost distance, Cost part) {
  Cost norm = 0;
  for (std::size_t role = 0; role < prices_.size(); ++role) {
    const bool is_least = prices_[role] == 0 && short_of_[role] < 0;
    direction_[role] = (is_least ? 0 : short_of_[role] * holder) + direction_[role] * kept_direction / 16;
    norm += direction_[role] * direction_[role] / holder;
  }
  if (norm == 0) return false;
  const Cost step = std::min(max_step, part * distance * holder / norm);
  for (std::size_t role = 0; role < prices_.size(); ++role) {
    prices_[role] = std::clamp<Cost>(prices_[role] + step * direction_[role] / (holder * holder), 0, max_price);
  }
  return true;
}

Prices::Entrants Prices::entrants(const Decisions& decisions) const {
  Entrants found;
  for (std::size_t robot = 0; robot < values_.size(); ++robot) {
    const Candidate& candidate = pool_.robots[robot];
    if (decisions[robot] == Decisions::State::out || candidate.alone.empty()) continue;
    const Cost bonus = candidate.is_bound ? bonus_of_bound : 0;
    // A robot that is in is paid for shared roles with a place or without.
    const bool is_paid = decisions[robot] != Decisions::State::in || needs_place(robot, decisions);
    found.robots.push_back(robot);
    found.costs.push_back(offset - bonus + (is_paid ? gain_of_shared(candidate) : 0));
    found.bonuses += bonus;
  }
  return found;
}

std::vector<Cost> Prices::costs_of_places(const Entrants& entrants, const std::vector<std::uint32_t>& role_of) const {
  std::vector<std::size_t> first(pool_.counts.size());
  for (std::size_t place = role_of.size(); place-- > 0;) first[role_of[place]] = place;
  const std::size_t robots = entrants.robots.size();
  std::vector<Cost> costs(role_of.size() * robots, forbidden);
  for (std::size_t at = 0; at < robots; ++at) {
    for (const Holding& one : pool_.robots[entrants.robots[at]].alone) {
      for (std::size_t place = first[one.role]; place < first[one.role] + pool_.counts[one.role]; ++place) {
        costs[place * robots + at] = one.cost * unit + entrants.costs[at];
      }
    }
  }
  return costs;
}

void Prices::count_short(const std::vector<bool>& robots) {
  for (std::size_t role = 0; role < short_of_.size(); ++role) {
    short_of_[role] = pool_.is_shared[role] ? Cost{pool_.counts[role]} : 0;
  }
  for (std::size_t robot = 0; robot < values_.size(); ++robot) {
    if (!robots[robot]) continue;
    for (const Holding& one : pool_.robots[robot].shared) {
      if (one.cost * unit < prices_[one.role]) --short_of_[one.role];
    }
  }
}

void Prices::fill_up(std::vector<bool>& robots, std::size_t most) const {
  std::vector<std::size_t> others;
  for (const std::size_t robot : free_) {
    if (!robots[robot]) others.push_back(robot);
  }
  std::ranges::sort(others, {}, [&](std::size_t robot) { return std::pair(values_[robot], robot); });
  auto there = static_cast<std::size_t>(std::ranges::count(robots, true));
  for (std::size_t at = 0; at < others.size() && there < most; ++at, ++there) robots[others[at]] = true;
}

Prices::Match Prices::match(const Decisions& decisions) {
  const auto role_of = pool_.roles_of_places();
  const Entrants entrants = this->entrants(decisions);
  const auto found = cheapest_matching(role_of.size(), entrants.robots.size(), costs_of_places(entrants, role_of));
  Match match;
  if (!found) return match;
  match.is_possible = true;
  match.robots = decisions.robots_in();
  for (const std::uint32_t at : found->robot_of) match.robots[entrants.robots[at]] = true;
  if (pool_.places == decisions.most()) {
    match.bound = found->cost - static_cast<Cost>(role_of.size()) * offset + entrants.bonuses;
    for (std::size_t role = 0; role < prices_.size(); ++role) {
      if (pool_.is_shared[role]) match.bound += prices_[role] * Cost{pool_.counts[role]};
    }
  }
  for (std::size_t place = 0; place < role_of.size(); ++place) {
    prices_[role_of[place]] = std::clamp<Cost>(found->price_of_place[place] - offset, 0, max_price);
  }
  count_short(match.robots);
  fill_up(match.robots, decisions.most());
  return match;
}

}  // namespace geminga::roles
