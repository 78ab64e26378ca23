// The relay that speaks on a link for those who are not heard there, where there are several.
#ifndef GEMINGA_DISCOVERY_RELAYING_SPEAKERS_HPP
#define GEMINGA_DISCOVERY_RELAYING_SPEAKERS_HPP

#include <cstddef>
#include <map>
#include <utility>

#include "base/time.hpp"
#include "env/env.hpp"
#include "geminga/service.hpp"

namespace geminga::relaying {

/// A relay stands back for another one that is nearer to a participant, or as near and of the lower identifier, until
/// it was not heard to speak for that participant for so many of its intervals: less than two, so that nobody is lost
/// meanwhile (ANNOUNCEMENT.md, "Relays").
inline constexpr double stands_back_intervals = 1.6;
/// The pairs of a link and a participant that are remembered. For one more all are forgotten, which costs copies that
/// receivers drop.
inline constexpr std::size_t max_speakers = 8192;

/// A relay and its distance from a participant, for those on the link; the smaller one speaks.
struct Distance {
  std::size_t hops = 0;
  ParticipantId relay{};
  friend auto operator<=>(const Distance&, const Distance&) = default;
};

class Speakers {
 public:
  using Place = std::pair<env::InterfaceIndex, ParticipantId>;

  /// Takes in that another relay has spoken for a participant on a link; `interval`: between two of its testimonies.
  void hear(const Place& place, const Distance& other, base::Duration interval, base::Instant now);
  /// Whether we stand back: another one speaks there.
  [[nodiscard]] bool has_better(const Place& place, const Distance& own, base::Instant now) const;
  /// Takes in that somebody there doubts the participant: whoever can, answers.
  void doubt(const Place& place) { others_.erase(place); }
  /// When the first of them falls silent; base::never: there is none.
  [[nodiscard]] base::Instant due() const { return due_; }
  /// Forgets those that have fallen silent, and tells whether there were any. Cost: linear when one is due.
  bool take_silent(base::Instant now);

 private:
  struct Other {
    Distance distance;
    base::Instant until;
  };
  std::map<Place, Other> others_;
  base::Instant due_ = base::never;
};

}  // namespace geminga::relaying

#endif
