// Limits of what is taken from mDNS and said there. Together they stay below the 1024 objects that avahi-daemon allows
// a client (objects-per-client-max): 1 + 256 + 480 + 256.
#ifndef GEMINGA_BRIDGE_AVAHI_LIMITS_HPP
#define GEMINGA_BRIDGE_AVAHI_LIMITS_HPP

#include <chrono>
#include <cstddef>

namespace geminga::bridge {

/// Types of services that are browsed at a time. Another one is left out and counted.
inline constexpr std::size_t max_types = 256;
/// Sightings (a service on one interface by one family) that are resolved at a time. More wait, and take the places of
/// those whose hosts do not answer.
inline constexpr std::size_t max_resolved = 480;
/// Sightings that wait to be resolved. One more is left out and counted.
inline constexpr std::size_t max_unresolved = 4096;
/// The longest pause of a sighting that nobody has answered, or of a service of ours that Avahi refused, in calls of
/// retry().
inline constexpr unsigned max_pause = 60;
/// Our services that are announced at a time. More are left out and counted.
inline constexpr std::size_t max_announced = 256;
/// Names that are tried for one of our services when others have them.
inline constexpr int max_names_tried = 8;
/// The label of a service's name, in octets (RFC 6763, section 4.1.1).
inline constexpr std::size_t max_label_bytes = 63;
/// Octets of one string of a TXT record (RFC 6763, section 6.1), and of the whole (section 6.2).
inline constexpr std::size_t max_txt_string_bytes = 255;
inline constexpr std::size_t max_txt_bytes = 1300;
/// Keys of a foreign TXT record that become attributes.
inline constexpr std::size_t max_txt_keys = 24;
/// Octets of a foreign name that become an attribute.
inline constexpr std::size_t max_shown_name_bytes = 200;
/// The time between two attempts to reach Avahi.
inline constexpr std::chrono::seconds avahi_pause{1};

}  // namespace geminga::bridge

#endif
