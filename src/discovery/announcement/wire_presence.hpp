// The statements of a presence about others, in their wire form.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_PRESENCE_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_PRESENCE_HPP

#include "discovery/announcement/announcement.hpp"
#include "discovery/announcement/announcement.pb.h"

namespace geminga::announcement {

/// Writes testimony, names and introductions of a presence. What is over its limit is left out, and so is an
/// introduction without a numeric address.
void write_presence(const Announcement& presence, wire::Announcement& message);

/// Reads them. False: the testimony has a wrong size, there are too many names or introductions, one is 0, or one is
/// introduced at no address of a single host.
[[nodiscard]] bool read_presence(const wire::Announcement& message, Announcement& presence);

}  // namespace geminga::announcement

#endif
