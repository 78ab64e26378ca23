// The rig of the tests of forged datagrams: a participant that speaks each interval, whoever else speaks in its name.
#ifndef GEMINGA_TESTS_DISCOVERY_MEMBERSHIP_FORGED_RIG_HPP
#define GEMINGA_TESTS_DISCOVERY_MEMBERSHIP_FORGED_RIG_HPP

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "discovery/membership/table_rig.hpp"

namespace geminga::membership {

inline constexpr auto interval = seconds(2);
inline constexpr ParticipantId victim{1};

/// A participant that speaks each interval, whoever else speaks in its name, and the registry that follows from all of
/// it.
struct Air {
  Air() { rig.source = "10.0.0.1"; }

  [[nodiscard]] announcement::Announcement truth() const {
    auto state = speaker(1, revision, {5, 6});
    state.peers[0].publications[0].publication.port = port;
    state.peers[0].subscriptions.push_back({7, announcement::simple_subscription()});
    return state;
  }
  Hearing say(announcement::Announcement state) {
    state.sequence = ++sequence;
    return hear(std::move(state), "10.0.0.1");
  }
  Hearing say() { return say(truth()); }
  Hearing hear(announcement::Announcement state, const std::string& source) {
    rig.source = source;
    const auto hearing = rig.hear(std::move(state), now);
    registry.take(rig.table);
    return hearing;
  }
  void pass(base::Duration time) {
    for (const auto end = now + time; now < end;) {
      now = std::min(end, std::max(now + base::Duration(1), rig.table.next_deadline()));
      rig.table.expire(now);
      registry.take(rig.table);
    }
  }
  /// Whether the told services of the victim are exactly those that it says.
  [[nodiscard]] bool is_right() const {
    const auto at = [](std::uint16_t p) { return "10.0.0.1:" + std::to_string(p) + " of robot1/vision"; };
    return registry.services == std::map<ServiceKey, std::string>{{{victim, PeerId{1}, 5}, at(port)},
                                                                  {{victim, PeerId{1}, 6}, at(5000)},
                                                                  {{victim, PeerId{1}, 7}, "sub of robot1/vision"}};
  }

  TableRig rig;
  Registry registry;
  base::Instant now = rig_start;
  std::uint64_t sequence = 0;
  std::uint64_t revision = 1;
  std::uint16_t port = 5000;
};

}  // namespace geminga::membership

#endif
