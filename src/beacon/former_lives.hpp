// Participants that have left a short while ago: what is known of them, in case that somebody else said goodbye.
#ifndef GEMINGA_BEACON_FORMER_LIVES_HPP
#define GEMINGA_BEACON_FORMER_LIVES_HPP

#include <deque>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include "beacon/announcement.hpp"
#include "beacon/neighbour_record.hpp"
#include "beacon/neighbour_table.hpp"

namespace geminga::beacon {

/// At most max_participants lives (an identifier with a boot nonce), each for goodbye_memory; the oldest gives way.
class FormerLives {
 public:
  void remember(std::unique_ptr<NeighbourRecord> record, base::Instant now);
  [[nodiscard]] bool contains(const Announcement& announcement, base::Instant now);
  /// A goodbye of a remembered life was heard again.
  void hear_goodbye(const Announcement& announcement, const Arrival& arrival);
  /// The life that this state proves to be alive; nothing if it may have been sent before the life left, or not by it.
  [[nodiscard]] std::unique_ptr<NeighbourRecord> take_alive(const Announcement& announcement, const Arrival& arrival);
  /// The oldest life that left with this boot nonce, heard from this source, whatever its identifier was; or null. A
  /// look at every life.
  [[nodiscard]] const NeighbourRecord* find(BootNonce boot, std::string_view source) const;
  /// Forgets the services of the oldest that has any, to make room; false: none has.
  bool give_way();

 private:
  using Key = std::pair<ParticipantId, BootNonce>;
  struct Life {
    std::unique_ptr<NeighbourRecord> record;
    base::Instant left;
  };
  void forget_old(base::Instant now);

  std::map<Key, Life> lives_;
  std::deque<std::pair<base::Instant, Key>> order_;  ///< by the time of leaving; may name one that is back
};

}  // namespace geminga::beacon

#endif
