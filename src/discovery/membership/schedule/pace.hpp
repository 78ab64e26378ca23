// The pace of a large team: how often each participant speaks, so that what a group sends does not grow with it (RFC
// 3550, section 6.2).
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_PACE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_PACE_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

/// Up to so many participants keep the configured interval; twice as many keep twice that, and so on.
inline constexpr std::size_t unhurried_participants = 64;
/// An interval is shortened again only when so few are left, so that one that comes and goes changes nothing.
inline constexpr std::size_t hurried_participants = 48;

/// How often the interval is to be doubled while so many others are known. `current` is how often it is doubled now;
/// the result is at most one more, since a receiver that missed the announcement of it expects the next datagram in the
/// shorter interval. `others` counts only participants heard for seasoned_after: a flood of strangers must not slow a
/// team down.
[[nodiscard]] constexpr std::uint8_t doublings_for(std::size_t others, std::uint8_t current) {
  const auto least = [others](std::size_t unhurried) {
    std::uint8_t doublings = 0;
    while (others > unhurried << doublings) ++doublings;
    return doublings;
  };
  static_assert(hurried_participants << announcement::max_doublings >= announcement::max_participants);
  const auto needed = least(unhurried_participants);
  if (needed > current) return static_cast<std::uint8_t>(current + 1);
  return std::min(current, least(hurried_participants));
}

}  // namespace geminga::membership

#endif
