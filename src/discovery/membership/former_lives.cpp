// Who is gone, and who only seems to be.
#include "discovery/membership/former_lives.hpp"

#include <algorithm>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

using base::Instant;

void FormerLives::forget(Lives::iterator life) {
  order_.erase({life->second.until, life->first});
  lives_.erase(life);
}

void FormerLives::remember(std::unique_ptr<NeighbourRecord> record, Instant now) {
  const auto until = now + record->memory(now);
  add(Life{.record = std::move(record), .left = now, .until = until, .echo = {}});
}

void FormerLives::remember_expired(std::unique_ptr<NeighbourRecord> record, Instant now) {
  const auto until = record->heard() + announcement::contest_intervals * record->interval();
  if (until <= now || !record->standing().is_confirmed) return;
  add(Life{.record = std::move(record), .left = now, .until = until, .echo = {}, .is_expired = true});
}

bool FormerLives::is_expired(const announcement::Announcement& announcement) const {
  const auto life = lives_.find(key_of(announcement));
  return life != lives_.end() && life->second.is_expired;
}

void FormerLives::add(Life life) {
  const Key key{life.record->services().owner().id, life.record->boot()};
  if (const auto former = lives_.find(key); former != lives_.end()) forget(former);
  order_.emplace(life.until, key);
  lives_.emplace(key, std::move(life));
  if (lives_.size() <= announcement::max_participants) return;
  forget(std::ranges::max_element(lives_, {}, [](const auto& each) { return each.second.record->since(); }));
}

const NeighbourRecord* FormerLives::find(const announcement::Announcement& announcement, Instant now) {
  while (!order_.empty() && order_.begin()->first <= now) forget(lives_.find(order_.begin()->second));
  const auto life = lives_.find(key_of(announcement));
  return life == lives_.end() ? nullptr : life->second.record.get();
}

void FormerLives::hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival) {
  const auto life = lives_.find(key_of(announcement));
  if (life != lives_.end()) life->second.record->note_goodbye(announcement, arrival);
}

const NeighbourRecord* FormerLives::find_alive(const announcement::Announcement& announcement, const Arrival& arrival) {
  const auto found = lives_.find(key_of(announcement));
  if (found == lives_.end()) return nullptr;
  auto& life = found->second;
  // Who was only not heard has said nothing that anything could be overtaken by.
  if (life.is_expired) return life.record->is_bound(announcement, arrival) ? life.record.get() : nullptr;
  switch (life.record->proof(announcement, arrival, life.left)) {
    case NeighbourRecord::Proof::none:
      return nullptr;
    case NeighbourRecord::Proof::echo: {
      // Its numbers may have been forged before it said them itself; then the next one is greater.
      const auto before = std::exchange(life.echo, announcement.sequence);
      return before && announcement.sequence > *before ? life.record.get() : nullptr;
    }
    case NeighbourRecord::Proof::alive:
      return life.record.get();
  }
  return nullptr;
}

std::unique_ptr<NeighbourRecord> FormerLives::take(const announcement::Announcement& announcement) {
  const auto life = lives_.find(key_of(announcement));
  auto record = std::move(life->second.record);
  forget(life);
  return record;
}

bool FormerLives::give_way() {
  NeighbourRecord* youngest = nullptr;
  for (const auto& [key, life] : lives_) {
    if (life.record->services().size() <= announcement::reserved_services) continue;
    if (youngest == nullptr || life.record->since() > youngest->since()) youngest = life.record.get();
  }
  if (youngest != nullptr) youngest->services().clear();
  return youngest != nullptr;
}

}  // namespace geminga::membership
