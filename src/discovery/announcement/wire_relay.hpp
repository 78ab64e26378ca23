// The wire form of what relays say.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_RELAY_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_RELAY_HPP

#include <cstddef>
#include <optional>
#include <span>

#include "discovery/announcement/announcement.pb.h"
#include "discovery/announcement/relayed.hpp"

namespace geminga::announcement {

/// Writes a word that is passed on. Requires that it is within its limits.
void write_relayed(const Relayed& relayed, wire::Announcement& message);
/// Reads a word that is passed on; nothing: a limit is violated.
[[nodiscard]] std::optional<Relayed> read_relayed(const wire::Announcement& message);

/// Adds as many entries of testimony as fit into a datagram of `room` octets with what `message` has, max_behind at
/// most. Returns how many. Ages and losses over their limits are cut.
std::size_t write_behind(std::span<const Behind> behind, std::size_t room, wire::Announcement& message);
/// Reads testimony into `behind`, whose memory is used again. Whether it is within its limits.
[[nodiscard]] bool read_behind(const wire::Announcement& message, std::vector<Behind>& behind);

}  // namespace geminga::announcement

#endif
