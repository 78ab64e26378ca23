// Robots that may be chosen for a task, and what each of them can hold.
#ifndef GEMINGA_DISCOVERY_ROLES_POOL_HPP
#define GEMINGA_DISCOVERY_ROLES_POOL_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "discovery/roles/matching.hpp"
#include "discovery/roles/task.hpp"

namespace geminga::roles {

struct Holding {
  std::uint32_t role = 0;
  Cost cost = 0;
};

struct Candidate {
  std::vector<Holding> shared{};  ///< by role
  std::vector<Holding> alone{};   ///< of these it holds one at most
  bool is_needed = false;         ///< it is chosen in any case
  bool is_bound = false;          ///< it is needed, and holds a role that is not shared
};

/// Holders by role, and the robots that they are chosen from. Each robot is counted once.
struct Filling {
  std::vector<std::vector<std::uint32_t>> of_role{};
  std::vector<bool> is_there{};
  Cost cost = 0;

  [[nodiscard]] std::size_t robots() const;
};

/// The part of a task that is left to choose once something is as little as can be: each choice from the pool is so,
/// and each choice that is so can be had from the pool.
struct Pool {
  std::vector<std::uint32_t> counts{};  ///< by role: holders that are still to be chosen
  std::vector<bool> is_shared{};
  std::vector<Candidate> robots{};
  std::vector<std::vector<std::uint32_t>> settled{};  ///< by role: who holds a shared role in any case
  std::size_t places = 0;                             ///< of all roles that are not shared

  /// Holders among these robots, as cheap as can be; nothing where they do not fill all roles.
  [[nodiscard]] std::optional<Filling> fill(const std::vector<bool>& robots) const;
  /// Each role that is not shared, as often as it counts.
  [[nodiscard]] std::vector<std::uint32_t> roles_of_places() const;
};

/// As few roles as can be change their holders. Nothing where nobody can do the task.
[[nodiscard]] std::optional<Pool> pool_of_fewest_changes(const Task& task);
/// The holders cost as little as can be, however many robots they are; former ones are not looked at. Nothing where
/// nobody can do the task.
[[nodiscard]] std::optional<Pool> pool_of_least_cost(const Task& task);

}  // namespace geminga::roles

#endif
