// Links that inverse properties imply: a link of R from x to y may be a link of S from y to x, or of S from x to y.
#ifndef GEMINGA_REASONING_EL_INDEX_IMPLIED_ROLES_HPP
#define GEMINGA_REASONING_EL_INDEX_IMPLIED_ROLES_HPP

#include <span>
#include <vector>

#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/index/roles.hpp"

namespace geminga::el {

/// A role that a link of another role implies, beside the super roles.
struct ImpliedRole {
  RoleId role{};
  bool is_backward = false;  ///< from the end of the link to its beginning
};

/// The implied roles of each role. Requires that the hierarchy is closed.
[[nodiscard]] std::vector<std::vector<ImpliedRole>> find_implied_roles(const Roles& roles,
                                                                       std::span<const InverseInclusion> inverses);

}  // namespace geminga::el

#endif
