// How long and how recently somebody has been heard: what decides who keeps its place when places are scarce.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_STANDING_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_STANDING_HPP

#include <algorithm>
#include <cstdint>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

/// The number of a datagram in the order of arrival: tells which of two was heard first, also within one instant.
using Turn = std::uint64_t;

/// Counts only datagrams whose number was not heard; a copy proves nothing. That numbers rise is not asked for: one
/// datagram with the highest number, forged, would make all that follow worthless.
struct Standing {
  base::Instant first;
  base::Instant last;
  bool is_confirmed = false;  ///< heard a second time

  void hear(base::Instant now) {
    is_confirmed = true;
    last = now;
  }
  [[nodiscard]] base::Duration span() const { return last - first; }
  /// Whether it was heard for a whole interval: all that can be asked of a newcomer within two.
  [[nodiscard]] bool is_proved() const { return span() >= announcement::stranger_interval; }
  /// The greater one keeps its place. Each moment for which it was heard is worth eight of silence, so the copies of a
  /// newcomer (0.3 s) keep its place until its next announcement (2 s); a whole interval is the most that counts, so
  /// that who was heard for long and is silent gives way to a newcomer of one interval.
  [[nodiscard]] base::Instant rank() const { return last + 8 * std::min(span(), announcement::stranger_interval); }
};

}  // namespace geminga::membership

#endif
