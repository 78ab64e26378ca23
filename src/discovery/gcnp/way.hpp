// The way to a participant that is heard through relays, as the daemon's lines tell it.
#ifndef GEMINGA_DISCOVERY_GCNP_WAY_HPP
#define GEMINGA_DISCOVERY_GCNP_WAY_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "discovery/gcnp/statement.hpp"

namespace geminga::gcnp {

struct Way {
  std::size_t hops = 0;      ///< relays between the participant and us; 0: it is heard directly
  std::string path;          ///< those of them that are known, joined by '/', the nearest to the participant first
  bool is_reachable = true;  ///< false: the address in the line cannot be reached from here
};

/// The key of the relays' names: a key only in a line with `hops`, otherwise an attribute.
inline constexpr std::string_view path_key = "path";

/// Appends `hops=N path=A/B` of a way through relays, and `reachable=no`; nothing of a way without either. Beside
/// `hops` an attribute `path` in the same line becomes `attr.path`.
void append_way(std::vector<Parameter>& parameters, const Way& way);

}  // namespace geminga::gcnp

#endif
