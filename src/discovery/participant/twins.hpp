// Whether anybody needs what we say on IPv4 to be said on IPv6 as well.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_TWINS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_TWINS_HPP

#include <cstddef>
#include <map>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Those on one twin (env::Interface::twin_of) that speak IPv6 alone, as each of their datagrams shows
/// (announcement::twin_link). ANNOUNCEMENT.md, "IPv4 and IPv6".
class Twins {
 public:
  /// So many are told apart on one interface; more are not needed to know that somebody is there.
  static constexpr std::size_t most_remembered = 64;

  /// Whether a datagram is said on IPv4, too, where this interface hears it.
  [[nodiscard]] static bool is_said_twice(const announcement::Announcement& announcement, const env::Interface& on);

  /// Somebody of our group was heard. On a twin he is spoken to until `until`, or until he says goodbye.
  void hear(const announcement::Announcement& announcement, const env::Interface& on, base::Instant until);
  /// Whether somebody on this twin is spoken to.
  [[nodiscard]] bool is_needed(env::InterfaceIndex twin, base::Instant now) const;

 private:
  std::map<env::InterfaceIndex, std::map<ParticipantId, base::Instant>> needed_until_;
};

}  // namespace geminga::participant

#endif
