#include "discovery/membership/claim/first_claims.hpp"

namespace geminga::membership {

void FirstClaims::forget_oldest() {
  claims_.erase(order_.front().second);
  order_.pop_front();
}

void FirstClaims::hear(const announcement::Announcement& claim, std::string_view source, base::Instant now, Turn turn) {
  prune(now);
  if (claims_.contains(claim.participant)) return;
  if (claims_.size() == max_claims) forget_oldest();
  claims_.emplace(claim.participant, Claim{claim.boot, std::string(source), now, turn});
  order_.emplace_back(now, claim.participant);
}

std::optional<Turn> FirstClaims::find(const announcement::Announcement& state, std::string_view source,
                                      base::Instant now) const {
  const auto found = claims_.find(state.participant);
  if (found == claims_.end() || found->second.at + claim_memory <= now) return std::nullopt;
  const auto& claim = found->second;
  return claim.boot == state.boot && claim.source == source ? std::optional(claim.turn) : std::nullopt;
}

}  // namespace geminga::membership
