// The first claim of each identifier: from then on, before its first state, the identifier belongs to the claimant.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_CLAIM_FIRST_CLAIMS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_CLAIM_FIRST_CLAIMS_HPP

#include <boost/unordered/unordered_flat_map.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"

namespace geminga::membership {

/// The number of a datagram in the order of arrival. It orders datagrams of one instant, too.
using Turn = std::uint64_t;

/// The time for which a claim is remembered. Its sender holds the identifier 90 ms after the claim, and announces it
/// several times within the next 300 ms and then in each interval.
inline constexpr base::Duration claim_memory = std::chrono::seconds(10);
/// Claims that are remembered. At ten thousand forged claims a second each is remembered for 0.8 s.
inline constexpr std::size_t max_claims = 8192;

/// The first claim of each identifier; of more than max_claims the oldest is forgotten.
class FirstClaims {
 public:
  /// Hears a claim of an identifier that nobody has, from this source address and with this turn.
  void hear(const announcement::Announcement& claim, std::string_view source, base::Instant now, Turn turn);
  /// Forgets claims that are older than claim_memory.
  void prune(base::Instant now) {
    while (!order_.empty() && order_.front().first + claim_memory <= now) forget_oldest();
  }
  /// The turn of the claim by which the sender of this state claimed its identifier, if that was the first claim.
  [[nodiscard]] std::optional<Turn> find(const announcement::Announcement& state, std::string_view source,
                                         base::Instant now) const;

 private:
  struct Claim {
    announcement::BootNonce boot{};
    std::string source;
    base::Instant at;
    Turn turn = 0;
  };
  void forget_oldest();

  boost::unordered_flat_map<ParticipantId, Claim> claims_;
  std::deque<std::pair<base::Instant, ParticipantId>> order_;  ///< oldest first
};

}  // namespace geminga::membership

#endif
