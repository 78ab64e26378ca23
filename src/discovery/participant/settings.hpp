// What a participant is told once, at its start, and the limits that it keeps.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_SETTINGS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_SETTINGS_HPP

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/sealing/seal.hpp"

namespace geminga::participant {

/// Named limits on what comes from local clients. What is over one is answered by 413, 429 or 503 and changes nothing.
/// The sizes of names, identities and services are those of an announcement (discovery/announcement/limits.hpp).
struct Limits {
  /// Connected clients. For one more a silent one gives way, else one of the user that runs the most, if that is not
  /// the new one's; where there is none, the new one is told 429 and closed.
  std::size_t peers = 128;
  /// Publications, and as many subscriptions, of one peer; one more is 429.
  std::size_t services_per_peer = 256;
  /// Publications and subscriptions of all peers together. For one more the peer that has the most loses its last one,
  /// if it has at least two more than the one that asks; else the answer is 429. Never more than can be announced.
  std::size_t services = announcement::max_services_per_participant;
  /// Subscriptions for `otm/stream` that one peer may ask room for when it says hello, and that all peers may. They
  /// count for none of the limits above, since they are not announced.
  std::size_t room_per_peer = 16'384;
  std::size_t room = 32'768;
  /// Lines of one peer in one second; a line over it is answered by 429 and not handled.
  std::size_t statements_per_second = 20'000;
  /// Lines over the limit above in one second, after which the connection is closed: the client floods.
  std::size_t flood_per_second = 20'000;
  /// A peer's next statement, and the next piece of its answer, wait while it has more than this to read. Less than
  /// `unread`, so that whoever has caught up does not lag again by that alone.
  std::size_t unread_before_more = std::size_t{64} * 1024;
  /// Octets that may wait for one peer. Behind it the peer lags: it is not told of each change any more, but of how
  /// things stand when it reads again. With `peers` it bounds what all of them can hold.
  std::size_t unread = std::size_t{256} * 1024;
  /// A peer that lags and reads nothing for so long is closed.
  base::Duration lag_patience = std::chrono::seconds(30);
  /// Where there is room for no more peers, one that offers and asks for nothing and has said nothing for so long gives
  /// way; one that never said anything does so at once.
  base::Duration quiet_patience = std::chrono::seconds(30);
};

/// Entries that a query looked through, and events that a statement brought its own peer, count as one more statement
/// each time that they come to so many. What others make of it costs the peer nothing.
inline constexpr std::size_t work_per_statement = 4;

struct Settings {
  /// What the team calls this participant, e.g. the host's name: announcement::is_valid_name(). Empty: its identifier
  /// is its name.
  std::string name;
  /// The same in all lives of this participant, so that the next one takes the place of the last at once; 0: nothing
  /// lasts.
  std::uint32_t lasting = 0;
  /// Only participants of the same group see each other.
  std::string group = "default";
  /// Time between two announcements of an unchanged state. Shorter: a lost participant is noticed sooner. Longer: fewer
  /// octets on the air. Within [announcement::min_interval, announcement::max_interval].
  base::Duration interval = std::chrono::seconds(2);
  /// With which keys announcements are sealed at first, and how; Participant::set_sealing() changes it.
  sealing::Policy sealing;
  /// Names the program in `query status`, e.g. "0.1.0".
  std::string version = "0";
  Limits limits;
};

}  // namespace geminga::participant

#endif
