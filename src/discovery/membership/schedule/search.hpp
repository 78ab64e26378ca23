// The search for lost participants: the sooner somebody speaks, the sooner both sides know that they are in reach
// again.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_SEARCH_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SCHEDULE_SEARCH_HPP

#include <algorithm>
#include <cstddef>
#include <optional>

#include "base/time.hpp"

namespace geminga::membership {

/// Right after a loss one of those who are left speaks once in this time, however many they are.
inline constexpr base::Duration search_spacing = std::chrono::milliseconds(100);
/// The time is doubled after this long, tripled after twice that, and so on, until it is the usual one.
inline constexpr base::Duration search_slows_in = std::chrono::seconds(30);

/// A participant is searched for if it was heard for at least so long: one forged datagram makes no participant.
inline constexpr base::Duration sought_after = std::chrono::seconds(5);

/// One participant's part in the search (ANNOUNCEMENT.md, "Who was lost").
class Search {
 public:
  /// Takes in that a participant is out of reach. `others`: how many were known before.
  void begin(std::size_t others, base::Instant now) {
    if (others > sought_) sought_ = others;
    if (!since_) since_ = now;
  }

  /// The time between two of our announcements while so many others are known; nothing if it is the usual one.
  [[nodiscard]] std::optional<base::Duration> spacing(std::size_t others, base::Duration interval, base::Instant now) {
    if (!since_) return std::nullopt;
    const auto all = static_cast<base::Duration::rep>(others + 1);
    const auto spacing = search_spacing * all * (1 + (now - *since_) / search_slows_in);
    if (others < sought_ && spacing < interval) return spacing;
    since_.reset();
    sought_ = 0;
    return std::nullopt;
  }

 private:
  std::size_t sought_ = 0;              ///< how many were known
  std::optional<base::Instant> since_;  ///< nothing: there is no search
};

}  // namespace geminga::membership

#endif
