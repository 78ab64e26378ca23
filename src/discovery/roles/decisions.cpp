#include "discovery/roles/decisions.hpp"

#include <algorithm>

namespace geminga::roles {

Decisions::Decisions(const Pool& pool, std::size_t most)
    : pool_(pool),
      most_(most),
      state_(pool.robots.size(), State::open),
      able_(pool.counts.size()),
      able_to_(pool.counts.size()),
      better_(pool.robots.size()),
      worse_(pool.robots.size()) {
  for (std::uint32_t robot = 0; robot < state_.size(); ++robot) {
    const Candidate& one = pool.robots[robot];
    const bool holds_place = !one.alone.empty() || pool.places < most;
    if (one.is_needed) {
      state_[robot] = State::in;
      ++chosen_;
    } else if ((one.shared.empty() && one.alone.empty()) || !holds_place) {
      state_[robot] = State::out;
      continue;
    }
    for (const Holding& held : one.shared) able_to_[held.role].push_back(robot);
    for (const Holding& held : one.alone) able_to_[held.role].push_back(robot);
    count(robot, true);
  }
  compare();
}

bool Decisions::is_complete() const { return std::ranges::find(state_, State::open) == state_.end(); }

std::vector<bool> Decisions::robots_in() const {
  std::vector<bool> all(state_.size());
  for (std::size_t robot = 0; robot < state_.size(); ++robot) all[robot] = state_[robot] == State::in;
  return all;
}

/// Robots and roles, squared.
void Decisions::compare() {
  constexpr Cost never = -1;
  const std::size_t roles = pool_.counts.size();
  std::vector<Cost> costs(state_.size() * roles, never);
  std::vector<std::uint64_t> able(state_.size());  // a bit for each role
  static_assert(max_roles <= 64);
  for (std::size_t robot = 0; robot < state_.size(); ++robot) {
    const auto enter = [&](const Holding& one) {
      costs[robot * roles + one.role] = one.cost;
      able[robot] |= std::uint64_t{1} << one.role;
    };
    std::ranges::for_each(pool_.robots[robot].shared, enter);
    std::ranges::for_each(pool_.robots[robot].alone, enter);
  }
  for (std::uint32_t robot = 0; robot < state_.size(); ++robot) {
    const Cost* const mine = &costs[robot * roles];
    for (std::uint32_t other = 0; other < state_.size(); ++other) {
      if (other == robot || state_[robot] != State::open || state_[other] != State::open) continue;
      if ((able[robot] & ~able[other]) != 0) continue;
      const Cost* const theirs = &costs[other * roles];
      bool is_better = true;
      bool is_equal = true;
      for (std::size_t role = 0; role < roles && is_better; ++role) {
        is_equal = is_equal && mine[role] == theirs[role];
        is_better = mine[role] == never || (theirs[role] != never && theirs[role] <= mine[role]);
      }
      if (!is_better || (is_equal && other > robot)) continue;
      better_[robot].push_back(other);
      worse_[other].push_back(robot);
    }
  }
}

void Decisions::count(std::size_t robot, bool is_there) {
  const auto change = [&](const Holding& one) { is_there ? ++able_[one.role] : --able_[one.role]; };
  std::ranges::for_each(pool_.robots[robot].shared, change);
  std::ranges::for_each(pool_.robots[robot].alone, change);
}

bool Decisions::decide(std::size_t robot, State state) {
  std::size_t next = trail_.size();
  if (!put(robot, state)) return false;
  for (; next < trail_.size(); ++next) {
    if (!follow(trail_[next])) return false;
  }
  return true;
}

bool Decisions::put(std::size_t robot, State state) {
  if (state_[robot] == state) return true;
  if (state_[robot] != State::open || (state == State::in && chosen_ == most_)) return false;
  state_[robot] = state;
  trail_.push_back(robot);
  if (state == State::in) {
    ++chosen_;
  } else {
    count(robot, false);
  }
  return true;
}

bool Decisions::follow(std::size_t robot) {
  if (state_[robot] == State::out) return follow_out(robot);
  if (!std::ranges::all_of(better_[robot], [&](std::uint32_t other) { return put(other, State::in); })) return false;
  if (chosen_ < most_) return true;
  for (std::size_t other = 0; other < state_.size(); ++other) {
    if (state_[other] == State::open && !put(other, State::out)) return false;
  }
  return true;
}

bool Decisions::follow_out(std::size_t robot) {
  const auto can_be_filled = [&](const Holding& one) {
    const std::uint32_t needed = pool_.counts[one.role];
    if (able_[one.role] != needed) return able_[one.role] > needed;
    return std::ranges::all_of(
        able_to_[one.role], [&](std::uint32_t other) { return state_[other] == State::out || put(other, State::in); });
  };
  return std::ranges::all_of(worse_[robot], [&](std::uint32_t other) { return put(other, State::out); }) &&
         std::ranges::all_of(pool_.robots[robot].shared, can_be_filled) &&
         std::ranges::all_of(pool_.robots[robot].alone, can_be_filled);
}

void Decisions::undo(std::size_t mark) {
  for (; trail_.size() > mark; trail_.pop_back()) {
    const std::size_t robot = trail_.back();
    if (state_[robot] == State::in) {
      --chosen_;
    } else {
      count(robot, true);
    }
    state_[robot] = State::open;
  }
}

}  // namespace geminga::roles
