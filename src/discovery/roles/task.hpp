// A task: roles, and the robots that suit each.
#ifndef GEMINGA_DISCOVERY_ROLES_TASK_HPP
#define GEMINGA_DISCOVERY_ROLES_TASK_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

namespace geminga::roles {

/// A robot that suits a role. Robots are numbers from 0.
struct Suited {
  std::uint32_t robot = 0;
  std::uint32_t cost = 0;  ///< the least sum of these is preferred; at most max_cost
};

struct Role {
  std::uint32_t count = 1;       ///< so many different robots hold it
  bool is_shared = false;        ///< a robot may hold it beside others; of roles that are not shared it holds one
  std::vector<Suited> suited{};  ///< each robot once
};

/// The most of each. Together they keep every sum of costs within 64 bits.
inline constexpr std::size_t max_robots = 1024;
inline constexpr std::size_t max_roles = 64;
inline constexpr std::uint32_t max_holders = 256;  ///< of all roles together
inline constexpr std::uint32_t max_cost = 1U << 20;

struct Task {
  std::uint32_t robots = 0;
  std::vector<Role> roles{};
  /// Those who held the roles, ascending; empty: there is nothing to keep. Has one list for each role otherwise.
  std::vector<std::vector<std::uint32_t>> former{};

  [[nodiscard]] bool is_within_limits() const {
    std::uint64_t holders = 0;
    for (const Role& role : roles) {
      holders += role.count;
      for (const Suited& one : role.suited) {
        if (one.robot >= robots || one.cost > max_cost) return false;
      }
    }
    return robots <= max_robots && roles.size() <= max_roles && holders <= max_holders &&
           (former.empty() || former.size() == roles.size());
  }
};

}  // namespace geminga::roles

#endif
