// Wraps words of others in a relay's own announcement, and unwraps what relays have wrapped.
#ifndef GEMINGA_DISCOVERY_RELAYING_VOUCHER_HPP
#define GEMINGA_DISCOVERY_RELAYING_VOUCHER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string_view>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/relaying/refusal.hpp"
#include "discovery/sealing/seal.hpp"
#include "discovery/sealing/vouched_words.hpp"

namespace geminga::relaying {

/// Whether a relay passes an announcement of this kind on. A presence is not: the relay's own testimony takes its
/// place.
[[nodiscard]] constexpr bool is_passed_on(announcement::Kind kind) {
  using announcement::Kind;
  return kind == Kind::state || kind == Kind::change || kind == Kind::claim || kind == Kind::goodbye;
}

/// A word as it was heard, before it is wrapped. Borrows its octets.
struct Word {
  std::span<const std::byte> datagram;       ///< as its sender said it, sealed or plain
  base::Duration age{};                      ///< the time since the first relay heard it; 0 if that is us
  std::span<const ParticipantId> through{};  ///< the relays that it has passed before us
  std::string_view source{};                 ///< the address from which the first relay heard it
};

/// Relaying as a daemon and a bridge have it in common: a bridge hands it what it takes from its server, and
/// stores or sends what it wraps. It needs a seal that holds the team's keys, and no participant. Everything about a
/// word that a holder of the key can say wrongly is argued in SEALING.md, "Relayed words".
///
/// Use: what was heard directly is told to note(), which says whether it is to be passed on; what came wrapped is given
/// to unwrap(). Either is wrapped for another link by wrap(), and the result is encoded and sealed like any
/// announcement.
class Voucher {
 public:
  /// Borrows the seal for its life.
  explicit Voucher(sealing::Seal& seal) : seal_(seal) {}
  Voucher(const Voucher&) = delete;
  Voucher& operator=(const Voucher&) = delete;

  /// Takes in a word that was heard directly: `opened` is what the seal made of it, `said` what it says. Whether it is
  /// new: it did not come on another way before.
  [[nodiscard]] bool note(const sealing::Opened& opened, const announcement::Announcement& said, base::Instant now);

  /// Opens what a relay has wrapped. The caller has opened the relay's own datagram before and believes its sender: by
  /// a seal, or without keys because the owner has named it. The result is valid until the next call, and its datagram,
  /// `relayed.relayed.word`, belongs to the caller. A refusal is counted. The word may be of any group.
  [[nodiscard]] std::expected<const announcement::Announcement*, Refusal> unwrap(
      const announcement::Announcement& relayed, ParticipantId self, base::Instant now);

  /// The announcement with which `self` passes a word on. Gives one reason more not to: it has passed max_hops relays,
  /// or it is over max_word_bytes. A refusal is counted. `self` is not 0.
  [[nodiscard]] std::expected<announcement::Announcement, Refusal> wrap(const Word& word, ParticipantId self);

  /// Counts a refusal that the caller has found, and gives it.
  Refusal refuse(Refusal refusal);
  [[nodiscard]] std::uint64_t refused(Refusal refusal) const { return refused_.at(static_cast<std::size_t>(refusal)); }

 private:
  sealing::Seal& seal_;
  sealing::VouchedWords words_;
  announcement::Announcement said_;  ///< the last word; its memory is used again
  std::array<std::uint64_t, refusal_count> refused_{};
};

}  // namespace geminga::relaying

#endif
