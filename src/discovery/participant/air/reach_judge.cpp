#include "discovery/participant/air/reach_judge.hpp"

#include "base/address.hpp"

namespace geminga::participant {

using membership::Reachability;

Reachability judged_reach(std::string_view address, std::string_view observed, env::RouteKind route) {
  const auto scope = base::address_scope(address);
  if (!scope || *scope == base::AddressScope::multicast || *scope == base::AddressScope::unspecified)
    return Reachability::reachable;
  if (route == env::RouteKind::none) return Reachability::no_route;
  const bool is_private = *scope == base::AddressScope::private_use || *scope == base::AddressScope::link_local;
  const bool is_translated = is_private && !observed.empty() && route == env::RouteKind::fallback;
  return is_translated ? Reachability::translated : Reachability::reachable;
}

}  // namespace geminga::participant
