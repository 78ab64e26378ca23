// Our state as it is announced, and what of it has changed of late, so that others are told of that alone.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_CHANGE_LOG_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_CHANGE_LOG_HPP

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"

namespace geminga::participant {

/// A revision counts as known to all when it was said so long ago: who has lost it has asked for it and was answered.
inline constexpr base::Duration change_settles_after = std::chrono::seconds(2);

class ChangeLog {
 public:
  /// The state of its revision, which is higher than any before. Not told of a state that nobody was told of: of many
  /// changes between two datagrams only the last counts.
  void update(announcement::Announcement state, base::Instant now);
  [[nodiscard]] const announcement::Announcement& state() const { return state_; }
  /// From the next update on only the whole state tells others what they need, until that is known to all.
  void begin_anew() { is_new_ = true; }

  /// The change that leads all others to the present state, from a revision that they know; nothing: there is none.
  [[nodiscard]] std::optional<announcement::Announcement> change() const;

 private:
  using Service = std::pair<PeerId, std::uint32_t>;
  struct Revision {
    base::Instant said;
    std::uint64_t number = 0;
  };

  announcement::Announcement state_;
  std::map<Service, std::uint64_t> changed_;  ///< with which revision; also those that exist no more
  std::deque<Revision> revisions_;            ///< the first one is known to all; then those that were said since
  bool is_new_ = true;
};

}  // namespace geminga::participant

#endif
