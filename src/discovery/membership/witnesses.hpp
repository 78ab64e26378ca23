// Who has heard whom: what we say of it, and what others say.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_HPP

#include <cstdint>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/records.hpp"

namespace geminga::membership {

/// The words of witnesses name nobody: both sides must know the same participants, which a fold of them shows
/// (ANNOUNCEMENT.md, "Witnesses").
class Witnesses {
 public:
  void set_self(ParticipantId id, announcement::BootNonce boot);
  /// Somebody is known from now on, or is not any more.
  void toggle(ParticipantId id, announcement::BootNonce boot);

  /// How lately we have heard each of them.
  [[nodiscard]] announcement::Witness say(const Records& records, base::Instant now) const;
  /// Takes in what a known participant says of them; whether it speaks of the same ones.
  bool hear(Records& records, const announcement::Announcement& presence, base::Instant now) const;

 private:
  [[nodiscard]] std::uint16_t members() const;

  ParticipantId self_{};
  announcement::BootNonce self_boot_{};
  std::uint64_t others_ = 0;  ///< fold of all that are known
};

}  // namespace geminga::membership

#endif
