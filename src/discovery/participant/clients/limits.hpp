// The limits that a participant keeps towards its local clients.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_LIMITS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_LIMITS_HPP

#include <cstddef>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::participant {

/// Named limits on what comes from local clients. What is over one is answered by 413, 429 or 503 and changes nothing.
/// The sizes of names, identities and services are those of an announcement (discovery/announcement/limits.hpp).
struct ClientLimits {
  /// Connected clients. For one more, a silent client gives way, else a client of the user who runs the most, if that
  /// user runs at least two more than the new client's. Where there is none, the new client is told 429 and closed.
  std::size_t peers = 128;
  /// Publications, and as many subscriptions, of one peer; one more is 429.
  std::size_t services_per_peer = 256;
  /// Publications and subscriptions of all peers together. For one more, the peer that has the most loses its last one,
  /// if it has at least two more than the peer that asks; else the answer is 429. Never more than can be announced.
  std::size_t services = announcement::max_services_per_participant;
  /// Subscriptions for `otm/stream` that one peer may ask room for when it says hello, and that all peers may. They
  /// count for none of the limits above, since they are not announced.
  std::size_t room_per_peer = 16'384;
  std::size_t room = 32'768;
  /// Lines of one peer in one second; a line over it is answered by 429 and not handled.
  std::size_t statements_per_second = 20'000;
  /// Lines over the limit above in one second, after which the connection is closed: the client floods.
  std::size_t flood_per_second = 20'000;
  /// A peer's next statement, and the next piece of its answer, wait while it has more octets than this to read. Less
  /// than `unread`, so that a peer that has caught up does not lag again by these alone.
  std::size_t unread_before_more = std::size_t{64} * 1024;
  /// Octets that may wait for one peer. With more, the peer lags: it is not told of each change, but by a resync of how
  /// things stand when it reads again. Together with `peers` this bounds the memory for all peers.
  std::size_t unread = std::size_t{256} * 1024;
  /// A peer that lags and reads nothing for this time is closed.
  base::Duration lag_patience = std::chrono::seconds(30);
  /// Where there is no room for another peer, one gives way that offers and asks for nothing and has been silent for
  /// this time; a peer that never said anything gives way at once.
  base::Duration quiet_patience = std::chrono::seconds(30);
};

/// So many entries that a query looked through, or events that a statement brought its own peer, count as one more
/// statement. Events of other peers cost the peer nothing.
inline constexpr std::size_t work_per_statement = 4;

}  // namespace geminga::participant

#endif
