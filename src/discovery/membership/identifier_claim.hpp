// How a participant comes by an identifier that nobody else has, and what it does about a clash (paper section 3.5.1).
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_IDENTIFIER_CLAIM_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_IDENTIFIER_CLAIM_HPP

#include <cstddef>
#include <cstdint>
#include <functional>

#include "base/random.hpp"
#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/token_bucket.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// Claims of one candidate, and the time between them; the identifier is held as long after the last one. 90 ms in all:
/// at 30 % loss an owner misses all three with a probability of 2.7 %, and then the clash is found at run time.
inline constexpr std::size_t claim_copies = 3;
inline constexpr base::Duration claim_spacing = std::chrono::milliseconds(30);
/// Candidates that are tried before a first identifier is held; the paper's iteration limit.
inline constexpr std::size_t max_claim_attempts = 8;
/// Later on a participant draws anew at most so often at once, and once more each redraw_refill. A true clash is over
/// with the first draw (the next one has a probability of 2^-32), so who needs more is being lied to, and then keeping
/// the identifier serves its peers better than a further draw. Each one costs the team a goodbye, a claim and a state.
inline constexpr std::int64_t redraw_capacity = 3;
inline constexpr base::Duration redraw_refill = std::chrono::seconds(20);

/// The claim of one participant. Deterministic for its seed and its calls.
class IdentifierClaim {
 public:
  /// `seed`: random bits from which the candidates are drawn. `is_taken` (may be empty) says which identifiers are
  /// known to be somebody's, e.g. by the neighbour table; it is asked while drawing and must outlive this object.
  explicit IdentifierClaim(std::uint64_t seed, std::function<bool(ParticipantId)> is_taken = {});

  /// Begins: draws the first candidate; its first claim is due at once.
  void start(base::Instant now);

  enum class Step : std::uint8_t {
    wait,        ///< nothing to do before due()
    send_claim,  ///< announce Kind::claim for id() on all interfaces
    claimed,     ///< id() is ours from now on: announce the state. Said once for each identifier
    failed,      ///< no first identifier was found: the participant shuts down (paper section 3.5.1). Said from then on
  };
  /// Moves on. Call when due() has come, until it says wait or failed.
  [[nodiscard]] Step step(base::Instant now);
  /// When step() has something to do, or base::never.
  [[nodiscard]] base::Instant due() const;

  enum class Verdict : std::uint8_t {
    ignore,   ///< nothing follows: a goodbye, or nothing of ours
    answer,   ///< the identifier is ours and a claimant wants it: answer at once (Schedule::contested())
    redrawn,  ///< we were claiming it ourselves: another candidate was drawn; id() changed, step() goes on
    dropped,  ///< two owners: both drop it. Say goodbye for the old identifier; id() is a new candidate, step() goes on
    kept,     ///< too many draws of late: the identifier, or the candidate, stays ours whatever others say
    failed,   ///< no first identifier was held after max_claim_attempts candidates
  };
  /// Our identifier (id()) was heard from another boot nonce in an announcement of this kind. Feed every one of them.
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
