// Participants that seem to be gone since a short while, and what is known of them in case that they are still alive.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_FORMER_INCARNATIONS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_FORMER_INCARNATIONS_HPP

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour/arrival.hpp"
#include "discovery/membership/neighbour/neighbour_record.hpp"

namespace geminga::membership {

/// At most max_participants incarnations (an identifier with a boot nonce) whose goodbye was heard, true or false, or
/// that lost their identifier to another one. Each is remembered for goodbye_memory or two of its intervals. When there
/// is no room, the youngest gives way. So a participant that has been known for as long as incarnations are remembered
/// keeps its entry: at most 255 others were known beside it, and only they can be older.
class FormerIncarnations {
 public:
  void remember(std::unique_ptr<NeighbourRecord> record, base::Instant now);
  /// Remembers a participant that was not heard until its deadline. It keeps its right to its identifier until it was
  /// silent for contest_intervals, so that nobody can take it in its name while it is only badly heard.
  void remember_expired(std::unique_ptr<NeighbourRecord> record, base::Instant now);
  /// Whether the sender of this is remembered as expired, so that it never said goodbye.
  [[nodiscard]] bool is_expired(const announcement::Announcement& announcement) const;
  /// The record of the sender of this; null: it is not remembered.
  [[nodiscard]] const NeighbourRecord* find(const announcement::Announcement& announcement, base::Instant now);
  /// Takes in that a goodbye of a remembered incarnation was heard again.
  void hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival);
  /// The record of the sender if this state proves that it is alive; null if the state may be older than its goodbye,
  /// or may be from somebody else.
  [[nodiscard]] const NeighbourRecord* find_alive(const announcement::Announcement& announcement,
                                                  const Arrival& arrival);
  /// Gives the record of the sender back and forgets it. Requires that it is remembered.
  [[nodiscard]] std::unique_ptr<NeighbourRecord> take(const announcement::Announcement& announcement);
  /// Forgets the services of the youngest that has more than its reserve, to make room; false: none has.
  bool give_way();
  /// Forgets those that were heard for less than seasoned_after, where memory is short.
  void shed();

 private:
  using Incarnation = std::pair<ParticipantId, announcement::BootNonce>;
  struct Former {
    std::unique_ptr<NeighbourRecord> record;
    base::Instant left;
    base::Instant until;
    std::optional<std::uint64_t> echo;  ///< the number of a datagram that came after `left` and was heard before
    bool is_expired = false;            ///< it was not heard, and did not say goodbye
  };
  using Map = std::map<Incarnation, Former>;
  static Incarnation incarnation_of(const announcement::Announcement& announcement) {
    return {announcement.participant, announcement.boot};
  }
  void add(Former former);
  void forget(Map::iterator position);

  Map map_;
  std::set<std::pair<base::Instant, Incarnation>> order_;  ///< by the time of being forgotten
};

}  // namespace geminga::membership

#endif
