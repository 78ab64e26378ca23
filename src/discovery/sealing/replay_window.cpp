#include "discovery/sealing/replay_window.hpp"

#include <algorithm>
#include <span>

namespace geminga::sealing {

ReplayWindow::ReplayWindow(env::InterfaceIndex interface, std::uint32_t counter, base::Instant now, bool is_alone)
    : highest_(counter), highest_at_(now), mark_(counter), mark_at_(now), floor_(counter) {
  ways_[0].interface = interface;
  ways_[0].came(is_alone) = 1;
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
  return way == nullptr || ((way->by_multicast | way->alone) >> behind & 1) == 0;
}

void ReplayWindow::rise(std::uint32_t counter, base::Instant now) {
  floor_ = floor(now);
  if (now - mark_at_ >= overtaken_time) {
    mark_ = counter;
    mark_at_ = now;
  }
  const std::uint32_t step = counter - highest_;
  for (Way& way : std::span(ways_).first(way_count_)) {
    for (const bool is_alone : {false, true})
      way.came(is_alone) = step >= window_counters ? 0 : way.came(is_alone) << step;
  }
  highest_ = counter;
  highest_at_ = now;
}

void ReplayWindow::take(env::InterfaceIndex interface, std::uint32_t counter, base::Instant now, bool is_alone) {
  if (counter > highest_) rise(counter, now);
  auto* way = const_cast<Way*>(find(interface));
  if (way == nullptr) {
    way = &ways_.at(way_count_++);
    *way = {.interface = interface};
  }
  way->came(is_alone) |= std::uint64_t{1} << (highest_ - counter);
}

bool ReplayWindow::is_copy(env::InterfaceIndex interface, std::uint32_t counter, bool is_alone) const {
  const Way* way = find(interface);
  if (way == nullptr || counter > highest_ || highest_ - counter >= window_counters) return false;
  const std::uint64_t bit = std::uint64_t{1} << (highest_ - counter);
  const std::uint64_t same = is_alone ? way->alone : way->by_multicast;
  const std::uint64_t other = is_alone ? way->by_multicast : way->alone;
  return (same & bit) == 0 && (other & bit) != 0;
}

void ReplayWindow::take_copy(env::InterfaceIndex interface, std::uint32_t counter, bool is_alone) {
  const_cast<Way*>(find(interface))->came(is_alone) |= std::uint64_t{1} << (highest_ - counter);
}

}  // namespace geminga::sealing
