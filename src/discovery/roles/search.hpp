// Search for the robots of a task among all that may be chosen.
#ifndef GEMINGA_DISCOVERY_ROLES_SEARCH_HPP
#define GEMINGA_DISCOVERY_ROLES_SEARCH_HPP

#include <cstddef>
#include <optional>

#include "discovery/roles/pool.hpp"

namespace geminga::roles {

/// Steps that a search may still take, and whether it would have taken more.
struct Steps {
  std::size_t left = 0;
  bool are_used_up = false;
};

/// As few robots as can be; costs are not looked at. Nothing if not even all robots fill all roles.
[[nodiscard]] std::optional<Filling> fewest_robots(const Pool& pool, Steps& steps);

/// The cheapest choice of at most as many robots as `filling` has, which is one.
[[nodiscard]] Filling cheapest_robots(const Pool& pool, Filling filling, Steps& steps);

}  // namespace geminga::roles

#endif
