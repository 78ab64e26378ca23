// The state machine of the identifier claim.
#include "beacon/identifier_claim.hpp"

#include <algorithm>
#include <utility>

namespace geminga::beacon {

using base::Instant;
using base::never;

IdentifierClaim::IdentifierClaim(std::uint64_t seed, std::function<bool(ParticipantId)> is_taken)
    : random_(seed), is_taken_(std::move(is_taken)) {}

void IdentifierClaim::start(Instant now) {
  if (phase_ == Phase::idle) draw(now);
}

bool IdentifierClaim::draw(Instant now) {
  if (attempts_ == max_claim_attempts) {
    phase_ = Phase::failed;
    id_ = {};
    due_ = now;
    return false;
  }
  ++attempts_;
  const auto old = id_;
  // At most max_participants of 2^32 identifiers are known, so this ends at once; a wrong is_taken must not hang us.
  for (int tries = 0; tries < 64; ++tries) {
    id_ = static_cast<ParticipantId>(random_.next());
    if (id_ != ParticipantId{} && id_ != old && (!is_taken_ || !is_taken_(id_))) break;
  }
  if (id_ == ParticipantId{}) id_ = ParticipantId{1};
  phase_ = Phase::claiming;
  claims_sent_ = 0;
  due_ = now;
  return true;
}

IdentifierClaim::Step IdentifierClaim::step(Instant now) {
  if (phase_ == Phase::failed) {
    due_ = never;
    return Step::failed;
  }
  if (phase_ != Phase::claiming || due_ > now) return Step::wait;
  if (claims_sent_ < claim_copies) {
    ++claims_sent_;
    // A timer that comes late must not make the whole claim late, nor its copies one.
    due_ = std::max(due_ + claim_spacing, now + claim_spacing / 2);
    return Step::send_claim;
  }
  phase_ = Phase::held;
  held_since_ = now;
  due_ = never;
  return Step::claimed;
}

Instant IdentifierClaim::due() const { return due_; }

IdentifierClaim::Verdict IdentifierClaim::conflict(Kind kind, Instant now) {
  if (kind == Kind::goodbye || phase_ == Phase::idle || phase_ == Phase::failed) return Verdict::ignore;
  if (phase_ == Phase::claiming) return draw(now) ? Verdict::redrawn : Verdict::failed;
  if (kind == Kind::claim) return Verdict::answer;
  if (now - held_since_ >= claim_settled_after) attempts_ = 0;
  return draw(now) ? Verdict::dropped : Verdict::failed;
}

}  // namespace geminga::beacon
