// The losses of participants that were given up: one that is badly heard comes and goes, and must not look new each
// time.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_FORMER_LOSSES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_FORMER_LOSSES_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour/arrival.hpp"
#include "discovery/membership/neighbour/neighbour_record.hpp"

namespace geminga::membership {

/// The ways that are remembered; the one that was remembered first gives way.
inline constexpr std::size_t max_former_losses = 64;

/// Only least_loss() looks so far back: a participant that returns is treated like a new one.
class FormerLosses {
 public:
  /// Remembers the losses of a participant that was not heard until its deadline.
  void remember(ParticipantId id, const NeighbourRecord& record);
  /// Takes in that something of it was heard, though it is not known again yet.
  void hear(const announcement::Announcement& announcement, const Arrival& arrival);
  /// Gives the losses to the record of the same incarnation, and forgets them.
  void hand_to(ParticipantId id, NeighbourRecord& record);
  [[nodiscard]] std::size_t size() const { return ways_.size(); }

 private:
  struct Way {
    ParticipantId id{};
    announcement::BootNonce boot{};
    env::InterfaceIndex interface{};
    std::uint32_t link = 0;
    LossWindow losses{};
  };
  std::vector<Way> ways_;
};

}  // namespace geminga::membership

#endif
