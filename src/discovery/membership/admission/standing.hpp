// How long and how recently a participant was heard: what decides who keeps its place when places are scarce.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_ADMISSION_STANDING_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_ADMISSION_STANDING_HPP

#include <algorithm>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

/// Counts only datagrams whose sequence number is new: a copy proves nothing. The numbers need not rise. If they had
/// to, one forged datagram with the highest number would make all later ones worthless.
struct Standing {
  base::Instant first;
  base::Instant last;
  bool is_confirmed = false;  ///< heard a second time

  void hear(base::Instant now) {
    is_confirmed = true;
    last = now;
  }
  [[nodiscard]] base::Duration span() const { return last - first; }
  /// Whether it was heard over a whole interval, which is all that can be asked of a newcomer within two.
  [[nodiscard]] bool is_proved() const { return span() >= announcement::stranger_interval; }
  /// The participant with the greater rank keeps its place. Time over which it was heard counts eight times as much as
  /// silence, so the first copies of a newcomer (0.3 s) keep its place until its next announcement (2 s). At most one
  /// interval counts, so that a silent participant gives way to a newcomer of one interval, however long it was heard.
  [[nodiscard]] base::Instant rank() const { return last + 8 * std::min(span(), announcement::stranger_interval); }
};

}  // namespace geminga::membership

#endif
