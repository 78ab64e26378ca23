// Our state as it was announced last, and its recent changes, so that only these need be announced.
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

/// A revision counts as known to all after this time: a participant that lost it has asked for it and was answered.
inline constexpr base::Duration change_settles_after = std::chrono::seconds(2);

class ChangeLog {
 public:
  /// Takes in a state that is announced, of a higher revision than any before. States that were not announced are left
  /// out: of many changes between two datagrams only the last counts.
  void update(announcement::Announcement state, base::Instant now);
  [[nodiscard]] const announcement::Announcement& state() const { return state_; }
  /// The next update begins anew: until its revision is known to all, only whole states are announced.
  void begin_anew() { is_new_ = true; }

  /// The change from a revision that all others know to the present state; nothing: there is none.
  [[nodiscard]] std::optional<announcement::Announcement> change() const;

 private:
  using Service = std::pair<PeerId, std::uint32_t>;
  struct Revision {
    base::Instant said;
    std::uint64_t number = 0;
  };

  announcement::Announcement state_;
  std::map<Service, std::uint64_t> changed_;  ///< the revision of each change; also of services that are gone
  std::deque<Revision> revisions_;            ///< the first is known to all; the others were announced since
  bool is_new_ = true;
};

}  // namespace geminga::participant

#endif
