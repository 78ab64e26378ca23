// Who was the first to claim an identifier: it is the sender's from then on, before its first state.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_CLAIMS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_CLAIMS_HPP

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/standing.hpp"

namespace geminga::membership {

/// A claim is remembered for so long: its identifier is held 90 ms after it, and announced several times within the
/// next 300 ms and then each interval.
inline constexpr base::Duration claim_memory = std::chrono::seconds(10);
/// Claims that are remembered. At ten thousand forged ones a second each is remembered for 0.8 s.
inline constexpr std::size_t max_claims = 8192;

/// The first claim of each identifier; of more than max_claims the oldest is forgotten.
class Claims {
 public:
  /// Hears a claim of an identifier that nobody has, with this turn.
  void hear(const announcement::Announcement& claim, const Arrival& arrival, Turn turn);
  /// With which turn the sender of this state has claimed its identifier, if it was the first to do so.
  [[nodiscard]] std::optional<Turn> find(const announcement::Announcement& state, const Arrival& arrival) const;

 private:
  struct Claim {
    announcement::BootNonce boot{};
    std::string source;
    base::Instant at;
    Turn turn = 0;
  };
  std::map<ParticipantId, Claim> claims_;
  std::deque<std::pair<base::Instant, ParticipantId>> order_;
};

}  // namespace geminga::membership

#endif
