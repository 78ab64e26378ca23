// How often everybody speaks where many share the air (RFC 3550, section 6.2: what a group sends does not grow with
// it).
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_PACE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_PACE_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

/// So many participants keep the configured interval; twice as many keep twice that, and so on.
inline constexpr std::size_t unhurried_participants = 64;
/// An interval is shortened again only when so few are left, so that one that comes and goes changes nothing.
inline constexpr std::size_t hurried_participants = 48;

/// How often the interval is to be doubled while so many others are known: at most once more than it is, since who has
/// not heard of it expects a word in the shorter interval. Those who were not heard for seasoned_after do not
/// count: a flood of them must not slow a team down. `current`: how often it is doubled now.
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
