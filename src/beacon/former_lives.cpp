// Who has left, and who only seemed to.
#include "beacon/former_lives.hpp"

#include "beacon/limits.hpp"

namespace geminga::beacon {

using base::Instant;

void FormerLives::forget_old(Instant now) {
  while (!order_.empty() && (order_.front().first + goodbye_memory <= now || order_.size() > max_participants)) {
    const auto& [left, key] = order_.front();
    const auto life = lives_.find(key);
    if (life != lives_.end() && life->second.left == left) lives_.erase(life);
    order_.pop_front();
  }
}

void FormerLives::remember(std::unique_ptr<NeighbourRecord> record, Instant now) {
  const Key key{record->services().owner().id, record->boot()};
  lives_.insert_or_assign(key, Life{std::move(record), now});
  order_.emplace_back(now, key);
  forget_old(now);
}

bool FormerLives::contains(const Announcement& announcement, Instant now) {
  forget_old(now);
  return lives_.contains({announcement.participant, announcement.boot});
}

void FormerLives::hear_goodbye(const Announcement& announcement, const Arrival& arrival) {
  const auto life = lives_.find({announcement.participant, announcement.boot});
  if (life != lives_.end()) life->second.record->note_goodbye(announcement, arrival);
}

std::unique_ptr<NeighbourRecord> FormerLives::take_alive(const Announcement& announcement, const Arrival& arrival) {
  const auto life = lives_.find({announcement.participant, announcement.boot});
  if (life == lives_.end() || !life->second.record->is_proved_alive(announcement, arrival, life->second.left)) {
    return nullptr;
  }
  auto record = std::move(life->second.record);
  lives_.erase(life);
  return record;
}

const NeighbourRecord* FormerLives::find(BootNonce boot, std::string_view source) const {
  const NeighbourRecord* oldest = nullptr;
  for (const auto& [key, life] : lives_) {
    if (key.second != boot || life.record->source() != source) continue;
    if (oldest == nullptr || life.record->standing().first < oldest->standing().first) oldest = life.record.get();
  }
  return oldest;
}

bool FormerLives::give_way() {
  for (const auto& [left, key] : order_) {
    const auto life = lives_.find(key);
    if (life == lives_.end() || life->second.record->services().size() == 0) continue;
    life->second.record->services().clear();
    return true;
  }
  return false;
}

}  // namespace geminga::beacon
