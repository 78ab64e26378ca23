// Participants that were there a short while ago: what is known of them, in case that they are still alive.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_FORMER_LIVES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_FORMER_LIVES_HPP

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour_record.hpp"
#include "discovery/membership/neighbour_table.hpp"

namespace geminga::membership {

/// At most max_participants lives (an identifier with a boot nonce) in whose name a goodbye was said or that lost their
/// identifier to another one, each for goodbye_memory or two of its intervals. When there is no room, the youngest
/// gives way. So a participant that has been known for as long as lives are remembered keeps its place: at most 255
/// others were known beside it, and only they can be older.
class FormerLives {
 public:
  void remember(std::unique_ptr<NeighbourRecord> record, base::Instant now);
  /// One that was not heard until its deadline keeps its right to its identifier until it was silent for
  /// contest_intervals, so that nobody can take it in its name while it is only badly heard.
  void remember_expired(std::unique_ptr<NeighbourRecord> record, base::Instant now);
  /// Whether the remembered life that this is said in the name of was not heard, and has not left.
  [[nodiscard]] bool is_expired(const announcement::Announcement& announcement) const;
  /// The remembered life that this is said in the name of; or null.
  [[nodiscard]] const NeighbourRecord* find(const announcement::Announcement& announcement, base::Instant now);
  /// A goodbye of a remembered life was heard again.
  void hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival);
  /// The life that this state proves to be alive; null if it may have been sent before the life left, or not by it.
  [[nodiscard]] const NeighbourRecord* find_alive(const announcement::Announcement& announcement,
                                                  const Arrival& arrival);
  /// Gives back what is known of a remembered life.
  [[nodiscard]] std::unique_ptr<NeighbourRecord> take(const announcement::Announcement& announcement);
  /// Forgets the services of the youngest that has more than its reserve, to make room; false: none has.
  bool give_way();

 private:
  using Key = std::pair<ParticipantId, announcement::BootNonce>;
  struct Life {
    std::unique_ptr<NeighbourRecord> record;
    base::Instant left;
    base::Instant until;
    std::optional<std::uint64_t> echo;  ///< the number of a datagram since then that was heard before
    bool is_expired = false;            ///< it was not heard, and has not left
  };
  using Lives = std::map<Key, Life>;
  static Key key_of(const announcement::Announcement& announcement) {
    return {announcement.participant, announcement.boot};
  }
  void add(Life life);
  void forget(Lives::iterator life);

  Lives lives_;
  std::set<std::pair<base::Instant, Key>> order_;  ///< by the time of being forgotten
};

}  // namespace geminga::membership

#endif
