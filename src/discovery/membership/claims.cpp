// First claims, in the order in which they are forgotten.
#include "discovery/membership/claims.hpp"

namespace geminga::membership {

void Claims::hear(const announcement::Announcement& claim, const Arrival& arrival, Turn turn) {
  while (!order_.empty() && order_.front().first + claim_memory <= arrival.now) {
    claims_.erase(order_.front().second);
    order_.pop_front();
  }
  if (claims_.contains(claim.participant)) return;
  if (claims_.size() == max_claims) {
    claims_.erase(order_.front().second);
    order_.pop_front();
  }
  claims_.emplace(claim.participant, Claim{claim.boot, std::string(arrival.source), arrival.now, turn});
  order_.emplace_back(arrival.now, claim.participant);
}

std::optional<Turn> Claims::find(const announcement::Announcement& state, const Arrival& arrival) const {
  const auto claim = claims_.find(state.participant);
  if (claim == claims_.end() || claim->second.at + claim_memory <= arrival.now) return std::nullopt;
  if (claim->second.boot != state.boot || claim->second.source != arrival.source) return std::nullopt;
  return claim->second.turn;
}

}  // namespace geminga::membership
