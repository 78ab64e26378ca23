// Who has left, and who only seemed to.
#include "beacon/former_lives.hpp"

#include <algorithm>

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

void FormerLives::remember(Life life, Instant now) {
  const Key key{life.id, life.boot};
  life.left = now;
  lives_.insert_or_assign(key, std::move(life));
  order_.emplace_back(now, key);
  forget_old(now);
}

Voice* FormerLives::find(const Announcement& announcement, const Arrival& arrival) {
  const auto life = lives_.find({announcement.participant, announcement.boot});
  if (life == lives_.end()) return nullptr;
  const auto voice = std::ranges::find_if(life->second.voices, [&](const Voice& each) {
    return each.interface == arrival.interface && each.link == announcement.link && each.source == arrival.source;
  });
  return voice == life->second.voices.end() ? nullptr : &*voice;
}

void FormerLives::hear_goodbye(const Announcement& announcement, const Arrival& arrival) {
  auto* voice = find(announcement, arrival);
  if (voice != nullptr && !voice->goodbye) voice->goodbye = announcement.sequence;
}

bool FormerLives::contains(const Announcement& announcement, Instant now) {
  forget_old(now);
  return lives_.contains({announcement.participant, announcement.boot});
}

std::optional<Life> FormerLives::take_alive(const Announcement& announcement, const Arrival& arrival) {
  const auto* voice = find(announcement, arrival);
  if (voice == nullptr || announcement.sequence <= voice->sequence) return std::nullopt;
  const auto life = lives_.find({announcement.participant, announcement.boot});
  // Nothing comes after a true goodbye. What has a lower number than the goodbye may have been overtaken by it, but not
  // for long.
  const bool is_after = voice->goodbye && announcement.sequence >= *voice->goodbye;
  if (!is_after && arrival.now - life->second.left < overtaken_time) return std::nullopt;
  auto alive = std::move(life->second);
  lives_.erase(life);
  return alive;
}

}  // namespace geminga::beacon
