#include "discovery/membership/claim/identifier_claim.hpp"

#include <algorithm>
#include <utility>

namespace geminga::membership {

using base::Instant;
using base::never;

IdentifierClaim::IdentifierClaim(std::uint64_t seed, std::function<bool(ParticipantId)> is_taken)
    : random_(seed), is_taken_(std::move(is_taken)) {}

void IdentifierClaim::start(Instant now) {
  if (phase_ == Phase::idle) (void)draw_first(now);
}

void IdentifierClaim::draw(Instant now) {
  const auto old = id_;
  // At most max_participants of 2^32 identifiers are taken, so this ends at once. A wrong is_taken must not hang us.
  for (int tries = 0; tries < 64; ++tries) {
    id_ = static_cast<ParticipantId>(random_.next());
    if (id_ != ParticipantId{} && id_ != old && (!is_taken_ || !is_taken_(id_))) break;
  }
  if (id_ == ParticipantId{}) id_ = ParticipantId{1};
  phase_ = Phase::claiming;
  claims_sent_ = 0;
  due_ = now;
}

IdentifierClaim::Verdict IdentifierClaim::draw_first(Instant now) {
  if (attempts_ == max_claim_attempts) {
    phase_ = Phase::failed;
    id_ = {};
    due_ = now;
    return Verdict::failed;
  }
  ++attempts_;
  draw(now);
  return Verdict::redrawn;
}

IdentifierClaim::Step IdentifierClaim::step(Instant now) {
  if (phase_ == Phase::failed) {
    due_ = never;
    return Step::failed;
  }
  if (phase_ != Phase::claiming || due_ > now) return Step::wait;
  if (claims_sent_ < claim_copies) {
    ++claims_sent_;
    // A late timer must neither delay the whole claim nor send its copies together.
    due_ = std::max(due_ + claim_spacing, now + claim_spacing / 2);
    return Step::send_claim;
  }
  phase_ = Phase::held;
  has_held_ = true;
  due_ = never;
  return Step::claimed;
}

Instant IdentifierClaim::due() const { return due_; }

IdentifierClaim::Verdict IdentifierClaim::conflict(announcement::Kind kind, Instant now) {
  if (kind == announcement::Kind::goodbye || phase_ == Phase::idle || phase_ == Phase::failed) return Verdict::ignore;
  if (!has_held_) return draw_first(now);
  const bool is_owner = phase_ == Phase::held;
  if (is_owner && kind == announcement::Kind::claim) return Verdict::answer;
  if (!redraws_.has(now)) return Verdict::kept;
  redraws_.take(now);
  draw(now);
  return is_owner ? Verdict::dropped : Verdict::redrawn;
}

}  // namespace geminga::membership
