// When the next announcement is due: every interval, at once on a change and quickly again, never too often.
#ifndef GEMINGA_BEACON_SCHEDULE_HPP
#define GEMINGA_BEACON_SCHEDULE_HPP

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/random.hpp"
#include "base/time.hpp"

namespace geminga::beacon {

/// What the schedule keeps to. Each time is argued in ANNOUNCEMENT.md, "When it is sent".
struct ScheduleOptions {
  /// The time between two announcements of an unchanged state.
  base::Duration interval = std::chrono::seconds(2);
};

/// The interval is spread by this share in both directions, so that robots started together drift apart.
inline constexpr double interval_jitter = 0.1;
/// After the first copy of a change, which goes at once, further ones follow so long after it: with five copies 99.8 %
/// of changes arrive at 30 % loss.
inline constexpr std::array<base::Duration, 4> repeat_delays = {
    std::chrono::milliseconds(20), std::chrono::milliseconds(60), std::chrono::milliseconds(140),
    std::chrono::milliseconds(300)};
/// Each of them is spread by this share in both directions.
inline constexpr double repeat_jitter = 0.2;
/// Never two announcements within this time. Changes within it are told together.
inline constexpr base::Duration min_spacing = std::chrono::milliseconds(3);
/// So many announcements may go at min_spacing; then only one each refill_time: a peer that changes its services
/// without end costs the air at most 1 / refill_time announcements a second.
inline constexpr std::size_t burst_capacity = 16;
inline constexpr base::Duration refill_time = std::chrono::milliseconds(50);
/// A newcomer is answered after a random time up to this, so that a team does not answer in one instant.
inline constexpr base::Duration max_newcomer_delay = std::chrono::milliseconds(20);
/// Newcomers start copies at most once in this time; one that comes within it is answered at its end, unless copies
/// that are due anyway reach it. Forged newcomers so cost at most five announcements a second.
inline constexpr base::Duration newcomer_spacing = std::chrono::seconds(1);
/// Goodbyes at the end, and the time between them.
inline constexpr std::size_t goodbye_copies = 3;
inline constexpr base::Duration goodbye_spacing = std::chrono::milliseconds(10);

/// One participant's schedule. Deterministic for its seed and its calls. It knows nothing of what is announced: when
/// take() says so, the caller announces its whole state on all interfaces.
class Schedule {
 public:
  /// `seed`: random bits for the jitter.
  Schedule(ScheduleOptions options, std::uint64_t seed);

  /// The state changed, or was claimed for: a copy is due at once (or as soon as the limits allow), then the repeats.
  /// Begins the schedule; before the first call nothing is due.
  void changed(base::Instant now);
  /// A participant is heard that does not know us yet (a newcomer, or a claimant): as changed(), but a little later and
  /// not more often than newcomer_spacing.
  void newcomer(base::Instant now);
  /// Somebody claims our identifier (IdentifierClaim::Verdict::answer): one copy is due at once, or as soon as the
  /// limits allow, so that each of its claims is answered before it holds the identifier.
  void contested(base::Instant now);
  /// Nothing is due any more until changed(): the identifier was lost, say.
  void pause();
  /// Only goodbyes are due from now on, the first at once, regardless of the limits.
  void stop(base::Instant now);

  /// When take() will say yes, or base::never.
  [[nodiscard]] base::Instant due() const;
  /// Whether an announcement (after stop(): a goodbye) is to be sent now; if so the schedule moves on. Ask until it
  /// says no.
  [[nodiscard]] bool take(base::Instant now);
  /// Whether stop() was called and all goodbyes have been taken.
  [[nodiscard]] bool is_finished() const;

 private:
  void begin_copies(base::Instant first);
  [[nodiscard]] base::Duration spread(base::Duration time, double share);
  [[nodiscard]] base::Instant wanted() const;
  [[nodiscard]] base::Instant allowed() const;
  void refill(base::Instant now);

  ScheduleOptions options_;
  base::Random random_;
  std::array<base::Instant, repeat_delays.size() + 1> copies_{};  ///< the copies of the last change
  std::size_t next_copy_ = repeat_delays.size() + 1;
  base::Instant periodic_ = base::never;
  base::Instant contested_ = base::never;     ///< when a claim to our identifier came
  base::Instant newcomer_due_ = base::never;  ///< when the copies for newcomers begin
  base::Instant newcomer_last_;               ///< when they last began
  bool had_newcomer_ = false;
  base::Instant last_sent_;
  bool has_sent_ = false;
  std::size_t tokens_ = burst_capacity;
  base::Instant refilled_;
  std::size_t goodbyes_left_ = 0;
  base::Instant goodbye_due_ = base::never;
  bool is_running_ = false;
  bool is_stopping_ = false;
};

}  // namespace geminga::beacon

#endif
