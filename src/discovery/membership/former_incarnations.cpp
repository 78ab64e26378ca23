#include "discovery/membership/former_incarnations.hpp"

#include <algorithm>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

using base::Instant;

void FormerIncarnations::forget(Map::iterator position) {
  order_.erase({position->second.until, position->first});
  map_.erase(position);
}

void FormerIncarnations::remember(std::unique_ptr<NeighbourRecord> record, Instant now) {
  const auto until = now + record->memory(now);
  add(Former{.record = std::move(record), .left = now, .until = until, .echo = {}});
}

void FormerIncarnations::remember_expired(std::unique_ptr<NeighbourRecord> record, Instant now) {
  const auto until = record->signs().heard() + announcement::contest_intervals * record->lasting_interval(now);
  if (until <= now || !record->standing().is_confirmed) return;
  add(Former{.record = std::move(record), .left = now, .until = until, .echo = {}, .is_expired = true});
}

bool FormerIncarnations::is_expired(const announcement::Announcement& announcement) const {
  const auto found = map_.find(incarnation_of(announcement));
  return found != map_.end() && found->second.is_expired;
}

void FormerIncarnations::add(Former former) {
  const Incarnation incarnation{former.record->origin().id, former.record->origin().boot};
  if (const auto known = map_.find(incarnation); known != map_.end()) forget(known);
  order_.emplace(former.until, incarnation);
  map_.emplace(incarnation, std::move(former));
  if (map_.size() <= announcement::max_participants) return;
  forget(std::ranges::max_element(map_, {}, [](const auto& each) { return each.second.record->origin().since; }));
}

const NeighbourRecord* FormerIncarnations::find(const announcement::Announcement& announcement, Instant now) {
  while (!order_.empty() && order_.begin()->first <= now) forget(map_.find(order_.begin()->second));
  const auto found = map_.find(incarnation_of(announcement));
  return found == map_.end() ? nullptr : found->second.record.get();
}

void FormerIncarnations::hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival) {
  const auto found = map_.find(incarnation_of(announcement));
  if (found != map_.end()) found->second.record->note_goodbye(announcement, arrival);
}

const NeighbourRecord* FormerIncarnations::find_alive(const announcement::Announcement& announcement,
                                                      const Arrival& arrival) {
  const auto found = map_.find(incarnation_of(announcement));
  if (found == map_.end()) return nullptr;
  auto& former = found->second;
  // An expired participant has not said goodbye, so this state cannot have been overtaken by a goodbye.
  if (former.is_expired) return former.record->is_bound(announcement, arrival) ? former.record.get() : nullptr;
  switch (former.record->ways().proof(announcement, arrival, former.left)) {
    case NeighbourWays::Proof::none:
      return nullptr;
    case NeighbourWays::Proof::echo: {
      // Its numbers may have been forged before it used them itself; then the next number is greater.
      const auto before = std::exchange(former.echo, announcement.sequence);
      return before && announcement.sequence > *before ? former.record.get() : nullptr;
    }
    case NeighbourWays::Proof::alive:
      return former.record.get();
  }
  return nullptr;
}

std::unique_ptr<NeighbourRecord> FormerIncarnations::take(const announcement::Announcement& announcement) {
  const auto found = map_.find(incarnation_of(announcement));
  auto record = std::move(found->second.record);
  forget(found);
  return record;
}

void FormerIncarnations::shed() {
  for (auto next = map_.begin(); next != map_.end();) {
    const auto one = next++;
    if (one->second.record->standing().span() < announcement::seasoned_after) forget(one);
  }
}

bool FormerIncarnations::give_way() {
  NeighbourRecord* youngest = nullptr;
  for (const auto& [incarnation, former] : map_) {
    if (former.record->services().size() <= announcement::reserved_services) continue;
    if (youngest == nullptr || former.record->origin().since > youngest->origin().since) youngest = former.record.get();
  }
  if (youngest != nullptr) youngest->services().clear();
  return youngest != nullptr;
}

}  // namespace geminga::membership
