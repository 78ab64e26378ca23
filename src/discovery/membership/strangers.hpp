// Participants that are heard, but whose state is not known.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_STRANGERS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_STRANGERS_HPP

#include <algorithm>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// The last few participants whose presence was heard before their state. Each is forgotten when it was not heard for a
/// while.
class Strangers {
 public:
  /// Adds a participant, or renews it. The oldest one gives way if there are too many.
  void hear(ParticipantId id, base::Instant now) {
    forget(id);
    if (heard_.size() == announcement::max_named) heard_.erase(heard_.begin());
    heard_.push_back({id, now});
  }
  void forget(ParticipantId id) {
    std::erase_if(heard_, [id](const Stranger& each) { return each.id == id; });
  }
  /// Forgets participants that were not heard for long. Returns whether one is left.
  bool prune(base::Instant now) {
    std::erase_if(heard_, [now](const Stranger& each) { return now - each.heard >= remembered; });
    return !heard_.empty();
  }

  struct Stranger {
    ParticipantId id{};
    base::Instant heard;
  };
  /// In the order in which they were last heard.
  [[nodiscard]] const std::vector<Stranger>& all() const { return heard_; }

 private:
  static constexpr base::Duration remembered = 2 * announcement::stranger_interval;
  std::vector<Stranger> heard_;
};

}  // namespace geminga::membership

#endif
