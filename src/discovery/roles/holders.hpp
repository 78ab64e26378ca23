// Holders of the roles of a task: the choice with the fewest robots.
#ifndef GEMINGA_DISCOVERY_ROLES_HOLDERS_HPP
#define GEMINGA_DISCOVERY_ROLES_HOLDERS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "discovery/roles/task.hpp"

namespace geminga::roles {

struct Holders {
  enum class Verdict : std::uint8_t {
    best,       ///< no other choice is better
    good,       ///< the search ended early: there may be a better one
    nobody,     ///< no choice of these robots fills all roles
    too_large,  ///< the task is beyond the limits of task.hpp
  };
  Verdict verdict = Verdict::nobody;
  std::vector<std::vector<std::uint32_t>> of_role{};  ///< robots, ascending; empty where nobody can
  std::size_t robots = 0;                             ///< different ones
  std::size_t changes = 0;                            ///< holdings that were not among the former ones
  std::uint64_t cost = 0;
};

/// Steps of the search: each bounds the costs of a branch, in a few microseconds for 100 robots and 20 roles.
inline constexpr std::size_t usual_steps = 20'000;

/// The best choice: the fewest changes if there are former holders, then the fewest robots, then the least cost. Equal
/// on every host. Branch and bound over the robots, first for their number and then for the cost (README.md).
[[nodiscard]] Holders best_holders(const Task& task, std::size_t steps = usual_steps);

/// The fewest holders that are lacking by role where nobody can do the whole task; all 0 where it can be done.
[[nodiscard]] std::vector<std::uint32_t> shortage(const Task& task);

}  // namespace geminga::roles

#endif
