// Announcements for tests: a small fixed one, and random ones by seed.
#ifndef GEMINGA_TESTS_DISCOVERY_ANNOUNCEMENT_ANNOUNCEMENTS_HPP
#define GEMINGA_TESTS_DISCOVERY_ANNOUNCEMENT_ANNOUNCEMENTS_HPP

#include <string>
#include <string_view>
#include <vector>

#include "base/random.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/announcement/codec.hpp"

namespace geminga::announcement {

/// The worked example of ANNOUNCEMENT.md.
Announcement worked_example();

/// The worked example of a diagnosis there.
Announcement worked_diagnosis();

/// A random valid announcement: all kinds, identities, modes, addresses, names up to their limits. Its entries fit.
Announcement random_announcement(base::Random& random, std::size_t max_services = 12);

/// A random presence.
Announcement random_presence(base::Random& random);

/// A random change, which may be too large for a datagram.
Announcement random_change(base::Random& random);

/// A publication of the numeric identity 7 at a port.
Publication simple_publication(std::uint16_t port = 5000);
Subscription simple_subscription();

/// Octets in hexadecimal, two digits each without spaces.
std::string to_hex_text(std::span<const std::byte> octets);
/// Octets of hexadecimal digits; white space is skipped.
std::vector<std::byte> octets_of(std::string_view hex);

/// All services of several parts as one announcement, as encode() was given them.
Announcement joined(const std::vector<Announcement>& parts);

}  // namespace geminga::announcement

#endif
