// What a participant is told once, at its start, and the limits that it keeps.
#ifndef GEMINGA_PARTICIPANT_SETTINGS_HPP
#define GEMINGA_PARTICIPANT_SETTINGS_HPP

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/time.hpp"

namespace geminga::participant {

/// Named limits on what comes from local clients. What is over one is answered by 413 or 429 and changes nothing.
struct Limits {
  /// Connected clients. One more is told 429 and closed; the others do not notice.
  std::size_t peers = 64;
  /// Publications, and as many subscriptions, of one peer; one more is 429. Their sum over all peers is bounded by what
  /// an announcement can carry (max_services).
  std::size_t services_per_peer = 1024;
  /// Publications and subscriptions of all peers together; one more is 429. More would only burden the air of the team.
  std::size_t services = 8192;
  /// Lines of one peer in one second; a line over it is answered by 429 and not handled.
  std::size_t statements_per_second = 20'000;
  /// Lines over the limit above in one second, after which the connection is closed: the client floods.
  std::size_t flood_per_second = 20'000;
  /// Statements of one peer that wait while the participant claims its identifier; one more is 503.
  std::size_t held_statements = 2048;
};

/// The longest name of a participant or a peer, in octets of UTF-8.
inline constexpr std::size_t max_name_bytes = 64;

struct Settings {
  /// What the team calls this participant, e.g. the host's name: UTF-8 without control characters, `/` or `,`, at most
  /// max_name_bytes (is_valid_name). Empty: its identifier is its name.
  std::string name;
  /// Only participants of the same group see each other.
  std::string group = "default";
  /// Time between two announcements of an unchanged state. Shorter: a lost participant is noticed sooner. Longer: fewer
  /// octets on the air.
  base::Duration interval = std::chrono::seconds(2);
  /// Names the program in `query status`, e.g. "0.1.0".
  std::string version = "0";
  Limits limits;
};

/// Whether a participant or a peer may be called so: 1 to max_name_bytes octets of UTF-8 without control characters,
/// `/` and `,` (which separate names in `provider=`).
[[nodiscard]] bool is_valid_name(const std::string& name);

}  // namespace geminga::participant

#endif
