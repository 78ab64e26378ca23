// How a datagram came in.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ARRIVAL_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ARRIVAL_HPP

#include <cstddef>
#include <string_view>
#include <vector>

#include "base/time.hpp"
#include "env/env.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// The way through relays on which something came.
struct Passage {
  /// The relays, the one that heard the participant itself first; at least one. Of testimony only the last is known.
  std::vector<ParticipantId> through;
  std::size_t hops = 1;             ///< how many they are
  env::InterfaceIndex interface{};  ///< ours, on which the last one speaks
  base::Duration age{};             ///< how long ago the participant said it
  double loss = 0;                  ///< the share of its datagrams that is lost on all hops together
  base::Duration interval{};        ///< of the last relay, between two of its testimonies
  base::Duration delay{};           ///< the intervals of all relays in `through` together
};

/// Borrows its texts, and the passage.
struct Arrival {
  env::InterfaceIndex interface{};
  std::string_view interface_name;  ///< becomes the zone of IPv6 link-local addresses
  /// The sender's numeric address. Its ways belong to it, and it stands for a sender that announces no address. May be
  /// empty.
  std::string_view source;
  base::Instant now;
  /// Whether a seal proves who sent it.
  bool is_sealed = false;
  /// Whether it was sent to us alone, and not to a group.
  bool is_alone = false;
  /// Null: it was heard directly.
  const Passage* passage = nullptr;
};

}  // namespace geminga::membership

#endif
