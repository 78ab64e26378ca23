#include "discovery/roles/gathering.hpp"

#include <algorithm>
#include <ranges>

namespace geminga::roles {

Gathering::Gathering(const Pool& pool)
    : pool_(pool), is_there_(pool.robots.size()), sharing_(pool.counts.size()), holders_(pool.counts.size()) {
  for (const std::uint32_t count : pool.counts) lacking_ += count;
}

void Gathering::bring(std::uint32_t robot) {
  take(robot);
  is_there_[robot] = true;
}

bool Gathering::take(std::uint32_t robot) {
  const std::size_t before = lacking_;
  for (const Holding& one : pool_.robots[robot].shared) {
    if (sharing_[one.role] < pool_.counts[one.role]) --lacking_;
  }
  if (place(robot)) --lacking_;
  if (lacking_ == before) return false;
  for (const Holding& one : pool_.robots[robot].shared) ++sharing_[one.role];
  is_there_[robot] = true;
  return true;
}

bool Gathering::place(std::uint32_t robot) {
  if (pool_.robots[robot].alone.empty()) return false;
  std::vector<bool> is_tried(holders_.size());
  return place(robot, is_tried);
}

/// Gives the robot a place, and those who lose theirs another. As deep as there are roles.
bool Gathering::place(std::uint32_t robot, std::vector<bool>& is_tried) {
  for (const Holding& one : pool_.robots[robot].alone) {
    if (is_tried[one.role]) continue;
    is_tried[one.role] = true;
    auto& holders = holders_[one.role];
    if (holders.size() < pool_.counts[one.role]) {
      holders.push_back(robot);
      return true;
    }
    for (std::uint32_t& holder : holders) {
      if (!place(holder, is_tried)) continue;
      holder = robot;
      return true;
    }
  }
  return false;
}

void Gathering::dismiss(std::uint32_t robot) {
  const Candidate& one = pool_.robots[robot];
  const auto is_spare = [&](const Holding& held) { return sharing_[held.role] > pool_.counts[held.role]; };
  if (!std::ranges::all_of(one.shared, is_spare)) return;
  for (const Holding& held : one.alone) {
    if (std::erase(holders_[held.role], robot) == 0) continue;
    const auto can_stand_in = [&](std::uint32_t other) {
      const auto holds = [&](const Holding& its) { return std::ranges::count(holders_[its.role], other) > 0; };
      return other != robot && is_there_[other] && std::ranges::none_of(pool_.robots[other].alone, holds) &&
             place(other);
    };
    if (std::ranges::any_of(std::views::iota(0U, static_cast<std::uint32_t>(is_there_.size())), can_stand_in)) break;
    holders_[held.role].push_back(robot);
    return;
  }
  for (const Holding& held : one.shared) --sharing_[held.role];
  is_there_[robot] = false;
}

std::vector<bool> gather(const Pool& pool, const std::vector<bool>& in, const std::vector<std::uint32_t>& others) {
  Gathering gathering(pool);
  for (const bool is_bound : {true, false}) {  // who has a place keeps one
    for (std::uint32_t robot = 0; robot < in.size(); ++robot) {
      if (in[robot] && pool.robots[robot].is_bound == is_bound) gathering.bring(robot);
    }
  }
  std::vector<std::uint32_t> taken;
  for (const std::uint32_t robot : others) {
    if (gathering.is_complete()) break;
    if (gathering.take(robot)) taken.push_back(robot);
  }
  if (!gathering.is_complete()) return {};
  for (const std::uint32_t robot : taken | std::views::reverse) gathering.dismiss(robot);
  return gathering.robots();
}

}  // namespace geminga::roles
