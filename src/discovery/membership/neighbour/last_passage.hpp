// How a participant was heard last: directly, or through which relays.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LAST_PASSAGE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LAST_PASSAGE_HPP

#include <optional>

#include "base/time.hpp"
#include "discovery/membership/neighbour/arrival.hpp"

namespace geminga::membership {

/// The passage of the last word of one participant.
class LastPassage {
 public:
  /// Takes in that it was heard directly.
  void hear_directly(base::Instant now) {
    passage_.reset();
    heard_directly_ = now;
  }
  /// Takes in that a relay passed on its word, or has testified for it. A longer way counts when the shorter one is no
  /// longer used.
  void hear_through(const Passage& passage, base::Instant now);
  /// Whether it was heard directly within the last `hold`.
  [[nodiscard]] bool is_direct(base::Duration hold, base::Instant now) const {
    return heard_directly_ && now - *heard_directly_ < hold;
  }
  /// The relays on the way to it; null: it was last heard directly.
  [[nodiscard]] const Passage* relayed() const { return passage_ ? &*passage_ : nullptr; }
  /// The time by which signs of life of a participant with this interval are late: the intervals of all relays on the
  /// way. A relay of which nothing is known counts as the slower one of the participant and the last relay.
  [[nodiscard]] base::Duration delay(base::Duration interval) const;

 private:
  std::optional<base::Instant> heard_directly_;
  std::optional<Passage> passage_;  ///< present while the last word came through a relay
  base::Instant used_{};            ///< when that passage was last used
};

}  // namespace geminga::membership

#endif
