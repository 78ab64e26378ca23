// Strangers that were heard while all places for participants were taken, with their standing.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_ADMISSION_WAITING_LIST_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_ADMISSION_WAITING_LIST_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/admission/standing.hpp"

namespace geminga::membership {

/// A stranger that was silent for so long begins anew. A participant that was silent for so long loses its place when
/// all places are wanted.
inline constexpr base::Duration longest_silence = 5 * announcement::stranger_interval;

/// At most max_waiting strangers, in buckets of four. In a full bucket the stranger of the lowest rank gives way. Takes
/// no memory before the first stranger.
class WaitingList {
 public:
  /// Random bits that choose the buckets, so that nobody can aim at the bucket of another.
  void set_secret(std::uint64_t secret) { secret_ = secret; }
  /// Hears a stranger. Gives its standing from the second time on, nothing the first time.
  [[nodiscard]] std::optional<Standing> hear(const announcement::Announcement& announcement, base::Instant now);
  /// Adds a participant that had to give its place away, so that it keeps its standing.
  void put(ParticipantId id, announcement::BootNonce boot, std::uint64_t sequence, const Standing& standing);

 private:
  struct Stranger {
    std::uint64_t key = 0;
    std::uint64_t sequence = 0;
    Standing standing;
  };
  [[nodiscard]] std::uint64_t key_of(ParticipantId id, announcement::BootNonce boot) const;
  /// The stranger with this key, or the one that gives way to it.
  [[nodiscard]] Stranger& entry_of(std::uint64_t key);

  std::uint64_t secret_ = 0;
  std::vector<Stranger> strangers_;
};

}  // namespace geminga::membership

#endif
