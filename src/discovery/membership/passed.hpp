// Which number a rising count had reached a while ago, so that what was overtaken is told from what comes too late.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_PASSED_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_PASSED_HPP

#include <cstdint>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

/// Remembers the count as it was at two instants of the past. A datagram with a number below one that was passed at
/// least overtaken_time ago (and at most twice that) is late: nothing on a link is overtaken for so long. It is not
/// enough to look at the newest number, which somebody else may raise all the time.
class Passed {
 public:
  Passed(std::uint64_t number, base::Instant now) { restart(number, now); }

  void restart(std::uint64_t number, base::Instant now) {
    newest_ = number;
    rose_ = now;
    mark_ = older_ = {0, now};
  }
  void rise(std::uint64_t number, base::Instant now) {
    if (number <= newest_) return;
    if (now - mark_.at >= announcement::overtaken_time) {
      older_ = mark_;
      mark_ = {newest_, now};
    }
    newest_ = number;
    rose_ = now;
  }
  /// Whether a number lower than the newest one comes too late to have been overtaken.
  [[nodiscard]] bool is_late(std::uint64_t number, base::Instant now) const {
    if (now - rose_ >= announcement::overtaken_time) return number < newest_;
    return number <= (now - mark_.at >= announcement::overtaken_time ? mark_ : older_).number;
  }

 private:
  /// The count just before an instant.
  struct Mark {
    std::uint64_t number = 0;
    base::Instant at;
  };
  std::uint64_t newest_ = 0;
  base::Instant rose_;
  Mark mark_;
  Mark older_;
};

}  // namespace geminga::membership

#endif
