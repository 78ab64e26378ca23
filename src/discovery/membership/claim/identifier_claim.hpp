// The claim of an identifier: how a participant gets one that nobody else has, and what it does in a clash (paper
// 3.5.1).
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_CLAIM_IDENTIFIER_CLAIM_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_CLAIM_IDENTIFIER_CLAIM_HPP

#include <cstddef>
#include <cstdint>
#include <functional>

#include "base/random.hpp"
#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/schedule/token_bucket.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// The number of claims of one candidate, and the time between them. The identifier is held the same time after the
/// last claim, 90 ms after the first. At 30 % loss an owner misses all three claims with a probability of 2.7 %; then
/// the clash is found at run time.
inline constexpr std::size_t claim_copies = 3;
inline constexpr base::Duration claim_spacing = std::chrono::milliseconds(30);
/// Candidates that are tried for a first identifier: the paper's iteration limit.
inline constexpr std::size_t max_claim_attempts = 8;
/// Further draws of a participant that has held an identifier: so many at once, then one each redraw_refill. One draw
/// ends a true clash (the next has a probability of 2^-32), so a participant that needs more is being lied to. Keeping
/// the identifier then serves its peers better: each draw costs the team a goodbye, a claim and a state.
inline constexpr std::int64_t redraw_capacity = 3;
inline constexpr base::Duration redraw_refill = std::chrono::seconds(20);

/// The claim of one participant. Deterministic for its seed and its calls.
class IdentifierClaim {
 public:
  /// `seed`: random bits from which the candidates are drawn. `is_taken` (may be empty) says which identifiers belong
  /// to known participants. It is called while drawing and must outlive this object.
  explicit IdentifierClaim(std::uint64_t seed, std::function<bool(ParticipantId)> is_taken = {});

  /// Draws the first candidate. Its first claim is due at once.
  void start(base::Instant now);

  enum class Step : std::uint8_t {
    wait,        ///< nothing to do before due()
    send_claim,  ///< announce Kind::claim for id() on all interfaces
    claimed,     ///< id() is ours: announce the state. Once for each identifier
    failed,      ///< no first identifier was found: the participant shuts down (paper section 3.5.1)
  };
  /// Takes the next step. Call at due(), until it returns wait or failed.
  [[nodiscard]] Step step(base::Instant now);
  /// When step() has something to do, or base::never.
  [[nodiscard]] base::Instant due() const;

  enum class Verdict : std::uint8_t {
    ignore,   ///< nothing follows: it was a goodbye, or we claim and hold nothing
    answer,   ///< a claimant wants our identifier: answer at once (Schedule::contested())
    redrawn,  ///< it was our candidate: id() is another one, step() goes on
    dropped,  ///< two owners: both drop it. Say goodbye for the old one; id() is a new candidate
    kept,     ///< too many draws of late: id() stays ours, whatever others say
    failed,   ///< no first identifier was held after max_claim_attempts candidates
  };
  /// Takes in that our identifier (id()) was heard from another boot nonce, in an announcement of this kind. Call for
  /// every such announcement.
  [[nodiscard]] Verdict conflict(announcement::Kind kind, base::Instant now);

  /// The candidate or the held identifier; ParticipantId{0} before start() and after failure.
  [[nodiscard]] ParticipantId id() const { return id_; }
  [[nodiscard]] bool is_held() const { return phase_ == Phase::held; }

 private:
  enum class Phase : std::uint8_t { idle, claiming, held, failed };
  void draw(base::Instant now);
  Verdict draw_first(base::Instant now);

  base::Random random_;
  std::function<bool(ParticipantId)> is_taken_;
  Phase phase_ = Phase::idle;
  ParticipantId id_{};
  bool has_held_ = false;     ///< any identifier, ever
  std::size_t attempts_ = 0;  ///< candidates drawn while none had been held
  TokenBucket redraws_{redraw_capacity, redraw_refill};
  std::size_t claims_sent_ = 0;
  base::Instant due_ = base::never;
};

}  // namespace geminga::membership

#endif
