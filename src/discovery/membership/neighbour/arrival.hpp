// How a datagram came in.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ARRIVAL_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ARRIVAL_HPP

#include <string_view>

#include "base/time.hpp"
#include "env/env.hpp"

namespace geminga::membership {

/// Borrows its texts.
struct Arrival {
  env::InterfaceIndex interface{};
  std::string_view interface_name;  ///< becomes the zone of IPv6 link-local addresses
  /// The sender's numeric address. Its ways belong to it, and it stands for a sender that announces no address. May be
  /// empty.
  std::string_view source;
  base::Instant now;
  /// Whether a seal proves who sent it.
  bool is_sealed = false;
};

}  // namespace geminga::membership

#endif
