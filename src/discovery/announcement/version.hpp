// The version of announcements; CONTRIBUTING.md says what it promises.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_VERSION_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_VERSION_HPP

#include <cstdint>

namespace geminga::announcement {

/// A receiver refuses another major version, and ignores what a newer minor one adds.
inline constexpr std::uint32_t format_major = 1;
inline constexpr std::uint32_t format_minor = 0;

}  // namespace geminga::announcement

#endif
