// The datagrams of one session that were heard: none is heard twice, and none that somebody has kept back is heard.
#ifndef GEMINGA_DISCOVERY_SEALING_REPLAY_WINDOW_HPP
#define GEMINGA_DISCOVERY_SEALING_REPLAY_WINDOW_HPP

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/time.hpp"
#include "discovery/sealing/limits.hpp"
#include "env/env.hpp"

namespace geminga::sealing {

/// A sliding window over counters (RFC 4303, section 3.4.3) that also closes with time: a datagram that comes more than
/// overtaken_time after a higher counter is refused, heard or not. A sender says each datagram once. If two of our
/// interfaces are on its link each of them hears it once, and each is a way to it. A host that is spoken to alone
/// beside multicasts gets it twice on one interface: by multicast and alone.
class ReplayWindow {
 public:
  /// Begins a window: the session has just proved itself by the datagram with this counter. Older ones count as heard.
  ReplayWindow(env::InterfaceIndex interface, std::uint32_t counter, base::Instant now, bool is_alone);

  /// Whether a datagram with this counter may be heard. Changes nothing, since the datagram may be forged.
  [[nodiscard]] bool is_open(env::InterfaceIndex interface, std::uint32_t counter, base::Instant now) const;
  /// Enters that it was heard. Requires is_open().
  void take(env::InterfaceIndex interface, std::uint32_t counter, base::Instant now, bool is_alone);

  /// Whether a datagram that is not open was heard by multicast and comes alone, or the other way round, for the first
  /// time. Changes nothing.
  [[nodiscard]] bool is_copy(env::InterfaceIndex interface, std::uint32_t counter, bool is_alone) const;
  /// Enters that the copy came, so that a further one is none. Requires is_copy().
  void take_copy(env::InterfaceIndex interface, std::uint32_t counter, bool is_alone);

 private:
  static_assert(window_counters == 64);
  /// The datagrams that came on one interface, by multicast and alone: bit i is the counter highest_ - i.
  struct Way {
    env::InterfaceIndex interface{};
    std::uint64_t by_multicast = 0;
    std::uint64_t alone = 0;
    [[nodiscard]] std::uint64_t& came(bool is_alone) { return is_alone ? alone : by_multicast; }
  };

  [[nodiscard]] std::uint32_t floor(base::Instant now) const;
  [[nodiscard]] const Way* find(env::InterfaceIndex interface) const;
  void rise(std::uint32_t counter, base::Instant now);

  std::uint32_t highest_;
  base::Instant highest_at_;
  std::uint32_t mark_;  ///< the highest one at mark_at_, which becomes the floor when it is old enough
  base::Instant mark_at_;
  std::uint32_t floor_;  ///< counters up to this are refused
  std::array<Way, max_ways> ways_{};
  std::size_t way_count_ = 1;
};

}  // namespace geminga::sealing

#endif
