// Those who were lost of late may come back into reach: the sooner somebody speaks, the sooner both sides know.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SEARCH_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SEARCH_HPP

#include <algorithm>
#include <cstddef>
#include <optional>

#include "base/time.hpp"

namespace geminga::membership {

/// Right after a loss somebody of those who are left speaks once in this time, however many they are.
inline constexpr base::Duration search_spacing = std::chrono::milliseconds(100);
/// That time is twice as long so much later, three times after twice that, and so on, until it is the usual one.
inline constexpr base::Duration search_slows_in = std::chrono::seconds(30);

/// Whoever was heard for so long is looked for when it is lost: one forged datagram makes nobody.
inline constexpr base::Duration sought_after = std::chrono::seconds(5);

/// One participant's part in it (ANNOUNCEMENT.md, "Who was lost").
class Search {
 public:
  /// Somebody is out of reach. `others`: how many were known before.
  void begin(std::size_t others, base::Instant now) {
    if (others > sought_) sought_ = others;
    if (!since_) since_ = now;
  }

  /// The time between two of our words while so many others are known; nothing where that is the usual one.
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
  std::size_t sought_ = 0;              ///< so many were known
  std::optional<base::Instant> since_;  ///< nothing: nobody is looked for
};

}  // namespace geminga::membership

#endif
