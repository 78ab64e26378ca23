#include "discovery/membership/former_losses.hpp"

#include <algorithm>

namespace geminga::membership {

void FormerLosses::remember(ParticipantId id, const NeighbourRecord& record) {
  for (const NeighbourWay& way : record.ways().all()) {
    if (way.is_relayed()) continue;
    if (ways_.size() == max_former_losses) ways_.erase(ways_.begin());
    ways_.push_back({.id = id,
                     .boot = record.origin().boot,
                     .interface = way.interface(),
                     .link = way.link(),
                     .losses = way.losses()});
  }
}

void FormerLosses::hear(const announcement::Announcement& announcement, const Arrival& arrival) {
  if (arrival.passage != nullptr) return;
  for (Way& way : ways_) {
    if (way.id == announcement.participant && way.boot == announcement.boot && way.interface == arrival.interface &&
        way.link == announcement.link)
      way.losses.count(announcement.sequence);
  }
}

void FormerLosses::hand_to(ParticipantId id, NeighbourRecord& record) {
  std::erase_if(ways_, [&](const Way& way) {
    if (way.id != id || way.boot != record.origin().boot) return false;
    record.go_on_from(way.interface, way.link, way.losses);
    return true;
  });
}

}  // namespace geminga::membership
