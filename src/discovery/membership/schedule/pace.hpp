// The pace of a large team: how often each participant speaks, so that what a group sends does not grow with it (RFC
// 3550, section 6.2).
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_PACE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_PACE_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/random.hpp"
#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
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

/// The number of announcements that say a longer interval before it is kept: a receiver that has heard none of them
/// would expect the next one earlier.
inline constexpr int announced_before_slower = 6;

/// The interval is spread by this share in both directions, so that robots started together drift apart.
inline constexpr double interval_jitter = 0.1;
/// The share by which the delay of each copy is spread in both directions.
inline constexpr double repeat_jitter = 0.2;

/// The interval of one participant, doubled in a large team, and the chance that spreads its times. Deterministic for
/// its seed and its calls.
class Pace {
 public:
  /// `interval`: the configured one. `seed`: random bits.
  Pace(base::Duration interval, std::uint64_t seed) : configured_(interval), kept_(interval), random_(seed) {}

  /// The interval that is announced.
  [[nodiscard]] base::Duration said_interval() const { return announcement::stretched(configured_, doublings_); }
  /// The interval that is kept: shorter than the announced one while that is new.
  [[nodiscard]] base::Duration kept_interval() const { return kept_; }
  [[nodiscard]] std::uint8_t doublings() const { return doublings_; }
  /// Whether a longer interval is announced that is not kept yet.
  [[nodiscard]] bool is_slowing() const { return announced_until_slower_ > 0; }
  /// Sets how often the announced interval is doubled. Returns whether a shorter one is kept from this instant on.
  bool set_doublings(std::uint8_t doublings);
  /// Counts an announcement, which says the announced interval.
  void count_announcement();

  /// A time that grows with the number of participants that share the air.
  [[nodiscard]] base::Duration slowed(base::Duration time) const { return time * (1 << doublings_); }
  /// A random time that differs from `time` by at most this share of it.
  [[nodiscard]] base::Duration spread(base::Duration time, double share);
  /// The kept interval, spread.
  [[nodiscard]] base::Duration next_interval() { return spread(kept_, interval_jitter); }
  /// A random time between the two.
  [[nodiscard]] base::Duration between(base::Duration least, base::Duration most) {
    return random_.between(least, most);
  }
  /// A random time of at most `most`.
  [[nodiscard]] base::Duration within(base::Duration most) { return between(base::Duration::zero(), most); }

 private:
  base::Duration configured_;
  base::Duration kept_;
  std::uint8_t doublings_ = 0;
  int announced_until_slower_ = 0;
  base::Random random_;
};

}  // namespace geminga::membership

#endif
