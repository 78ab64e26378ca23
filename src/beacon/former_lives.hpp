// Participants that have left a short while ago, and by what a late datagram is told from one that proves them alive.
#ifndef GEMINGA_BEACON_FORMER_LIVES_HPP
#define GEMINGA_BEACON_FORMER_LIVES_HPP

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "beacon/announcement.hpp"
#include "beacon/neighbour_table.hpp"
#include "beacon/standing.hpp"

namespace geminga::beacon {

/// How one life of a participant was heard on one way.
struct Voice {
  env::InterfaceIndex interface{};
  std::uint32_t link = 0;
  std::string source;
  std::uint64_t sequence = 0;            ///< the highest one heard
  std::optional<std::uint64_t> goodbye;  ///< the number of the goodbye that was heard there
};

/// What is remembered of one life: an identifier with a boot nonce.
struct Life {
  ParticipantId id{};
  BootNonce boot{};
  std::vector<Voice> voices;
  Standing standing;
  base::Instant left;
};

/// At most max_participants lives, each for goodbye_memory; the oldest gives way.
class FormerLives {
 public:
  void remember(Life life, base::Instant now);
  /// A goodbye of a remembered life was heard again.
  void hear_goodbye(const Announcement& announcement, const Arrival& arrival);
  [[nodiscard]] bool contains(const Announcement& announcement, base::Instant now);
  /// The life that this state proves to be alive; nothing if it may have been sent before the life left, or not by it.
  /// A life that is returned is forgotten.
  [[nodiscard]] std::optional<Life> take_alive(const Announcement& announcement, const Arrival& arrival);
  void forget(ParticipantId id, BootNonce boot) { lives_.erase({id, boot}); }

 private:
  using Key = std::pair<ParticipantId, BootNonce>;
  [[nodiscard]] Voice* find(const Announcement& announcement, const Arrival& arrival);
  void forget_old(base::Instant now);

  std::map<Key, Life> lives_;
  std::deque<std::pair<base::Instant, Key>> order_;  ///< by the time of leaving; may name one that is forgotten
};

}  // namespace geminga::beacon

#endif
