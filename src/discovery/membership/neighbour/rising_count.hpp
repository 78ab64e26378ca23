// A rising count and what it was a while ago, so that an overtaken number is told from a late one.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_RISING_COUNT_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_RISING_COUNT_HPP

#include <cstdint>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

/// Remembers the count at two instants of the past. A number is late if the count passed it at least overtaken_time ago
/// (or at most twice that): no link delays a datagram for so long. The newest number alone is not enough, since
/// somebody else may raise it all the time.
class RisingCount {
 public:
  RisingCount(std::uint64_t number, base::Instant now) { restart(number, now); }

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
  /// Whether a number below the newest one comes too late to have been overtaken.
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
