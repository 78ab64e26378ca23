// What a participant is told once, at its start, and the limits that it keeps.
#ifndef GEMINGA_PARTICIPANT_SETTINGS_HPP
#define GEMINGA_PARTICIPANT_SETTINGS_HPP

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/time.hpp"
#include "beacon/limits.hpp"

namespace geminga::participant {

/// Named limits on what comes from local clients. What is over one is answered by 413, 429 or 503 and changes nothing.
/// The sizes of names, identities and services are those of an announcement (beacon/limits.hpp).
struct Limits {
  /// Connected clients. One more is told 429 and closed; the others do not notice.
  std::size_t peers = 128;
  /// Publications, and as many subscriptions, of one peer; one more is 429. Well below `services`, so that no one peer
  /// can take the share of the others.
  std::size_t services_per_peer = 256;
  /// Publications and subscriptions of all peers together; one more is 429. Never more than can be announced.
  std::size_t services = beacon::max_services_per_participant;
  /// Lines of one peer in one second; a line over it is answered by 429 and not handled.
  std::size_t statements_per_second = 20'000;
  /// Lines over the limit above in one second, after which the connection is closed: the client floods.
  std::size_t flood_per_second = 20'000;
  /// Statements of one peer that wait while the participant claims its identifier, and their octets; one more is 503.
  std::size_t held_statements = 4096;
  std::size_t held_bytes = 1024 * 1024;
};

/// Events that a statement caused, and entries that a query looked through, count as one more statement each time that
/// they come to so many: a peer cannot make the daemon work without end for others to wait.
inline constexpr std::size_t work_per_statement = 4;

struct Settings {
  /// What the team calls this participant, e.g. the host's name: beacon::is_valid_name(). Empty: its identifier is its
  /// name.
  std::string name;
  /// Only participants of the same group see each other.
  std::string group = "default";
  /// Time between two announcements of an unchanged state. Shorter: a lost participant is noticed sooner. Longer: fewer
  /// octets on the air. Within [beacon::min_interval, beacon::max_interval].
  base::Duration interval = std::chrono::seconds(2);
  /// Names the program in `query status`, e.g. "0.1.0".
  std::string version = "0";
  Limits limits;
};

}  // namespace geminga::participant

#endif
