// Dual stack: whether anybody needs what we say on IPv4 to be said on IPv6 as well.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_DUAL_STACK_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_DUAL_STACK_HPP

#include <cstddef>
#include <map>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/sealing/seal.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// The participants that speak IPv6 alone, on the IPv6 side of each dual-stack interface
/// (env::Interface::ipv6_side_of), as each of their datagrams shows (announcement::ipv6_side_bit). ANNOUNCEMENT.md,
/// "IPv4 and IPv6".
class DualStack {
 public:
  /// Participants that are told apart on one interface; to know that somebody is there, more are not needed.
  static constexpr std::size_t most_remembered = 64;

  /// Whether this interface also hears a datagram on IPv4.
  [[nodiscard]] static bool is_said_twice(const announcement::Announcement& announcement, const env::Interface& on);

  /// A participant of our group was heard. On an IPv6 side it is spoken to until `until`, or until it says goodbye.
  void hear(const announcement::Announcement& announcement, const env::Interface& on, base::Instant until);
  /// Whether all that we say is said on this interface, too: always on one that is no IPv6 side, and on an IPv6 side
  /// while somebody there speaks IPv6 alone or is asked by the seal there alone.
  [[nodiscard]] bool speaks_on(const env::Interface& interface, sealing::Seal& seal, base::Instant now) const;

 private:
  std::map<env::InterfaceIndex, std::map<ParticipantId, base::Instant>> needed_until_;
};

}  // namespace geminga::participant

#endif
