// The words that a server has kept, until the relay that has sealed them testifies for them: SEALING.md, "Kept words".
#ifndef GEMINGA_DISCOVERY_RELAYING_RECALL_HPP
#define GEMINGA_DISCOVERY_RELAYING_RECALL_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/relaying/word_chain.hpp"
#include "discovery/sealing/seal.hpp"

namespace geminga::relaying {

/// Kept words that wait for testimony: a team of a thousand, some of whose states need several. More are dropped.
inline constexpr std::size_t max_pending_words = 4096;
/// The time for which a kept word waits: a server gives all of them within seconds, and a relay testifies each
/// interval.
inline constexpr base::Duration pending_time = std::chrono::seconds(60);

/// Holds kept words back until they are proved. Nothing in them counts before.
class Recall {
 public:
  /// Borrows the seal for its life.
  explicit Recall(sealing::Seal& seal) : seal_(seal) {}

  /// Takes in what a server has kept. Whether it waits: it is sealed with a key of ours, a relay's wrapping of a state
  /// or a change, and there is room.
  bool take(std::span<const std::byte> envelope, base::Instant now);
  /// The words that tell all of the revision for which a relay testifies, in the order in which they are to be heard,
  /// or none. Of each participant those that this session of this relay has sealed; all others are kept back. The words
  /// are as old as the testimony. `session`: the proved one that has said the testimony.
  [[nodiscard]] std::vector<announcement::Announcement> recall(sealing::Session session, ParticipantId relay,
                                                               const announcement::Behind& testimony);
  [[nodiscard]] std::size_t pending() const { return pending_count_; }

 private:
  struct Pending {
    std::uint32_t counter = 0;  ///< of its sender's session: the order in which they were said
    WordPlace place;
    announcement::Relayed relayed;
  };
  struct Participant {
    ParticipantId relay{};
    base::Instant taken{};  ///< the last of them
    std::vector<Pending> words;
  };
  void forget_old(base::Instant now);

  sealing::Seal& seal_;
  std::map<std::pair<sealing::Session, ParticipantId>, Participant> pending_;  ///< by the relay's session
  std::size_t pending_count_ = 0;
  announcement::Announcement wrapping_, said_;  ///< the last ones; their memory is used again
};

}  // namespace geminga::relaying

#endif
