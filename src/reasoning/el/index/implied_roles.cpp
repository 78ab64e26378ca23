// A walk over super roles and told inverses, which counts the inverses modulo two.
#include "reasoning/el/index/implied_roles.hpp"

#include <cstddef>
#include <cstdint>

namespace geminga::el {

//  R(x,y) says S(x,y) for R <* S, and S(y,x) where an inverse is told
std::vector<std::vector<ImpliedRole>> find_implied_roles(const Roles& roles,
                                                         std::span<const InverseInclusion> inverses) {
  std::vector<std::vector<ImpliedRole>> implied(roles.count());
  if (inverses.empty()) return implied;
  std::vector<std::vector<RoleId>> inverses_of(roles.count());
  for (const InverseInclusion& told : inverses) inverses_of[static_cast<std::size_t>(told.sub)].push_back(told.super);
  std::vector<std::uint32_t> seen_from(roles.count() * 2, static_cast<std::uint32_t>(-1));
  std::vector<ImpliedRole> stack;
  for (std::uint32_t role = 0; role < roles.count(); ++role) {
    const auto reach = [&](RoleId to, bool is_backward) {
      std::uint32_t& seen = seen_from[static_cast<std::size_t>(to) * 2 + (is_backward ? 1 : 0)];
      if (seen == role) return;
      seen = role;
      stack.push_back({to, is_backward});
      if (is_backward || !roles.is_sub_role(RoleId{role}, to)) implied[role].push_back({to, is_backward});
    };
    reach(RoleId{role}, false);
    while (!stack.empty()) {
      const ImpliedRole next = stack.back();
      stack.pop_back();
      for (const RoleId super : roles.supers(next.role)) reach(super, next.is_backward);
      for (const RoleId inverse : inverses_of[static_cast<std::size_t>(next.role)]) reach(inverse, !next.is_backward);
    }
  }
  return implied;
}

}  // namespace geminga::el
