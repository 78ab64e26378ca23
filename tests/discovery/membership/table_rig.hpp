// A neighbour table under test, and participants that talk to it.
#ifndef GEMINGA_TESTS_DISCOVERY_MEMBERSHIP_TABLE_RIG_HPP
#define GEMINGA_TESTS_DISCOVERY_MEMBERSHIP_TABLE_RIG_HPP

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "discovery/announcement/announcements.hpp"
#include "discovery/membership/neighbour_table.hpp"

namespace geminga::membership {

using std::chrono::milliseconds;
using std::chrono::seconds;

inline constexpr base::Instant rig_start{seconds(1000)};
inline constexpr ParticipantId self_id{0xaaaaaaaa};
inline constexpr announcement::BootNonce self_boot{0xaaaa};
inline constexpr env::InterfaceIndex eth{2};
inline constexpr env::InterfaceIndex wlan{3};

/// One change as a line: "put pub 00000001/1/5 at 10.0.0.1", "remove pub 00000001/1/5 withdrawn", ...
std::string line_of(const Change& change);

/// A registry that does all changes.
struct Registry {
  /// Does the changes since the last call. Removing an unknown service is a failure.
  void take(NeighbourTable& table);

  std::map<ServiceKey, std::string> services;  ///< "10.0.0.1:5000 of robot1/vision"
};

struct TableRig {
  TableRig() { table.set_self(self_id, self_boot); }

  /// Hears an announcement from `source`. One without a sequence number gets the next of its incarnation and link.
  Hearing hear(announcement::Announcement announcement, base::Instant now = rig_start, env::InterfaceIndex on = eth) {
    auto& last = sequences[{announcement.boot, announcement.link}];
    if (announcement.sequence == 0) announcement.sequence = last + 1;
    last = std::max(last, announcement.sequence);
    const std::string_view name = on == eth ? "eth0" : "wlan0";
    return table.hear(announcement, {on, name, source, now});
  }
  /// The changes since the last call as lines.
  std::vector<std::string> lines() {
    std::vector<std::string> all;
    for (const auto& change : table.take_changes()) all.push_back(line_of(change));
    return all;
  }

  NeighbourTable table{"default"};
  std::string source;
  std::map<std::pair<announcement::BootNonce, std::uint32_t>, std::uint64_t> sequences;  ///< the last ones
};

/// A participant with one peer, and as many publications as it has numbers.
announcement::Announcement speaker(std::uint32_t id, std::uint64_t revision,
                                   const std::vector<std::uint32_t>& numbers = {5});
/// Such a participant, of which only `numbers` are in part `part` of `count`.
announcement::Announcement part_of(announcement::Announcement announcement, std::uint32_t part, std::uint32_t count,
                                   const std::vector<std::uint32_t>& numbers);

}  // namespace geminga::membership

#endif
