// The copies of a change: the first at once, the others soon after it, as many as the loss asks for.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_COPIES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_COPIES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/membership/schedule/pace.hpp"

namespace geminga::membership {

/// The content of an announcement.
enum class Say : std::uint8_t {
  nothing,   ///< nothing is due
  state,     ///< the whole state
  change,    ///< the latest changes if they can be said alone, else the state
  presence,  ///< our presence: the revision of our state, and what we have heard of others
  goodbye,   ///< the end
};

/// The times of further copies after the first copy of a change, which goes at once. The first few are of the state, as
/// many as the loss asks for (state_copies()). The others are presences: a receiver that has heard no state learns from
/// them that it lacks it.
inline constexpr std::array<base::Duration, 8> repeat_delays = {
    std::chrono::milliseconds(8),   std::chrono::milliseconds(20),  std::chrono::milliseconds(36),
    std::chrono::milliseconds(60),  std::chrono::milliseconds(120), std::chrono::milliseconds(220),
    std::chrono::milliseconds(400), std::chrono::milliseconds(700)};
/// The number of presences behind the copies of the state, but not more than those.
inline constexpr std::size_t presence_copies = 2;
/// The same while the loss is not known, as when a team starts.
inline constexpr std::size_t unknown_presence_copies = 4;
/// The times of further presences after a change if at least bad_loss is lost. One receiver in 500 misses all copies
/// above, and would learn of the change only by the next periodic presence.
inline constexpr std::array<base::Duration, 3> bad_presence_delays = {
    std::chrono::milliseconds(300), std::chrono::milliseconds(550), std::chrono::milliseconds(850)};
/// The times of further presences after a change where many share the air, as many as the interval is doubled: in a
/// large team somebody misses all copies above.
inline constexpr std::array<base::Duration, announcement::max_doublings> late_presence_delays = {
    std::chrono::milliseconds(1'200), std::chrono::seconds(2),          std::chrono::seconds(3),
    std::chrono::milliseconds(4'500), std::chrono::milliseconds(6'500), std::chrono::seconds(9),
    std::chrono::seconds(12),         std::chrono::seconds(15)};
/// The share of lost datagrams from which on the loss is bad.
inline constexpr double bad_loss = 0.4;
/// The number of copies of a changed state at this loss (ANNOUNCEMENT.md, "When it is sent"). Nothing: the loss is not
/// known.
[[nodiscard]] std::size_t state_copies(std::optional<double> loss);
/// A change goes at once. Those that come within this time after it share the next datagram, and so on; while they go
/// on coming, the time doubles up to the longest one. So a client that says all that it has is not told state by state.
inline constexpr base::Duration change_spacing = std::chrono::milliseconds(20);
inline constexpr base::Duration longest_change_spacing = std::chrono::milliseconds(160);

/// The copies of the last change that are still to come.
class Copies {
 public:
  /// The instant of the first copy of a change that comes now: at once, or together with the changes before it.
  [[nodiscard]] base::Instant gather(base::Instant now);
  /// Replaces the copies by those of a change. The first is of `what` and due at `first`.
  void plan(Say what, base::Instant first, std::optional<double> loss, Pace& pace);
  /// Adds a presence.
  void add_presence(base::Instant due);
  /// When the next copy of that kind is due; base::never: there is none.
  [[nodiscard]] base::Instant next(Say what) const;
  /// How many copies of the whole state are still to come.
  [[nodiscard]] std::size_t states() const;
  /// Forgets the copies of state and change that are due, which what is said now replaces.
  void drop_told(base::Instant now);
  /// Forgets the presences that are due.
  void drop_presences(base::Instant now);
  /// Forgets all copies.
  void clear();

 private:
  struct Copy {
    base::Instant due;
    Say what;
  };

  std::vector<Copy> copies_;                 ///< in order of time
  std::optional<base::Instant> change_due_;  ///< the first copy of the last change
  bool is_change_pending_ = false;           ///< that was not said yet
  base::Duration change_wait_ = change_spacing;
};

}  // namespace geminga::membership

#endif
