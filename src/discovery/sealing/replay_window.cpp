#include "discovery/sealing/replay_window.hpp"

#include <algorithm>
#include <span>

namespace geminga::sealing {

ReplayWindow::ReplayWindow(env::InterfaceIndex interface, std::uint32_t counter, base::Instant now)
    : highest_(counter), highest_at_(now), mark_(counter), mark_at_(now), floor_(counter) {
  ways_[0] = {interface, 1};
}

const ReplayWindow::Way* ReplayWindow::find(env::InterfaceIndex interface) const {
  const auto ways = std::span(ways_).first(way_count_);
  const auto found = std::ranges::find(ways, interface, &Way::interface);
  return found == ways.end() ? nullptr : &*found;
}

std::uint32_t ReplayWindow::floor(base::Instant now) const {
  if (now - highest_at_ >= overtaken_time) return highest_;
  return now - mark_at_ >= overtaken_time ? mark_ : floor_;
}

bool ReplayWindow::is_open(env::InterfaceIndex interface, std::uint32_t counter, base::Instant now) const {
  const Way* way = find(interface);
  if (way == nullptr && way_count_ == ways_.size()) return false;
  if (counter > highest_) return true;
  const std::uint32_t behind = highest_ - counter;
  if (counter <= floor(now) || behind >= window_counters) return false;
  return way == nullptr || (way->heard >> behind & 1) == 0;
}

void ReplayWindow::rise(std::uint32_t counter, base::Instant now) {
  floor_ = floor(now);
  if (now - mark_at_ >= overtaken_time) {
    mark_ = counter;
    mark_at_ = now;
  }
  const std::uint32_t step = counter - highest_;
  for (Way& way : std::span(ways_).first(way_count_)) way.heard = step >= window_counters ? 0 : way.heard << step;
  highest_ = counter;
  highest_at_ = now;
}

void ReplayWindow::take(env::InterfaceIndex interface, std::uint32_t counter, base::Instant now) {
  if (counter > highest_) rise(counter, now);
  auto* way = const_cast<Way*>(find(interface));
  if (way == nullptr) {
    way = &ways_.at(way_count_++);
    *way = {interface, 0};
  }
  way->heard |= std::uint64_t{1} << (highest_ - counter);
}

}  // namespace geminga::sealing
