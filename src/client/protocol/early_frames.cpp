#include "client/protocol/early_frames.hpp"

#include <utility>

#include "client/protocol/limits.hpp"

namespace geminga::client {

void EarlyFrames::put(const PeerAddress& from, const ReadFrame& frame, base::Instant now) {
  drop_old(now);
  if (frame.payload.size() > max_early_octets) return;
  while (kept_.size() >= max_early_frames || octets_ + frame.payload.size() > max_early_octets) drop_first();
  octets_ += frame.payload.size();
  kept_.push_back(
      {now + early_patience, from, frame.life, frame.payload.size(), {frame.octets.begin(), frame.octets.end()}});
}

std::vector<EarlyFrames::Kept> EarlyFrames::take(const PeerAddress& from, Life life, base::Instant now) {
  drop_old(now);
  std::vector<Kept> taken;
  std::deque<Kept> others;
  for (Kept& kept : kept_) {
    if (kept.from == from && kept.life == life) {
      octets_ -= kept.payload_bytes;
      taken.push_back(std::move(kept));
    } else {
      others.push_back(std::move(kept));
    }
  }
  kept_ = std::move(others);
  return taken;
}

void EarlyFrames::drop_first() {
  octets_ -= kept_.front().payload_bytes;
  kept_.pop_front();
}

void EarlyFrames::drop_old(base::Instant now) {
  while (!kept_.empty() && kept_.front().until <= now) drop_first();
}

}  // namespace geminga::client
