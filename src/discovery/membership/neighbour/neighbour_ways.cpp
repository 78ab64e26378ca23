#include "discovery/membership/neighbour/neighbour_ways.hpp"

#include <algorithm>
#include <tuple>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;

NeighbourWay* NeighbourWays::find(const announcement::Announcement& announcement, const Arrival& arrival) {
  const auto way =
      std::ranges::find_if(ways_, [&](const NeighbourWay& each) { return each.is_way_of(announcement, arrival); });
  return way == ways_.end() ? nullptr : &*way;
}

const NeighbourWay* NeighbourWays::find_bound(const announcement::Announcement& announcement,
                                              const Arrival& arrival) const {
  const auto way = std::ranges::find_if(ways_, [&](const NeighbourWay& each) {
    return each.is_way_of(announcement, arrival) && (each.is_relayed() || each.source() == arrival.source);
  });
  return way == ways_.end() ? nullptr : &*way;
}

const NeighbourWay* NeighbourWays::find_once_bound(const announcement::Announcement& announcement,
                                                   const Arrival& arrival) const {
  if (const auto* way = find_bound(announcement, arrival)) return way;
  const auto way = std::ranges::find_if(ways_, [&](const auto& each) { return each.is_way_of(announcement, arrival); });
  return way != ways_.end() && way->was_of(arrival.source) ? &*way : nullptr;
}

NeighbourWays::Proof NeighbourWays::proof(const announcement::Announcement& announcement, const Arrival& arrival,
                                          Instant left) const {
  const auto* way = find_once_bound(announcement, arrival);
  if (way == nullptr) return Proof::none;
  const bool is_heard = way->has(announcement.sequence);
  // A true goodbye has the highest number. A lower number may have been overtaken by it, but not for long.
  const bool is_after = way->goodbye && announcement.sequence >= *way->goodbye && !is_heard;
  if (!is_after && arrival.now - left < announcement::overtaken_time) return Proof::none;
  return is_heard ? Proof::echo : Proof::alive;
}

bool NeighbourWays::may_open(const announcement::Announcement& announcement, const Arrival& arrival, Duration hold,
                             bool is_contested) {
  if (ways_.empty() || arrival.passage != nullptr) return true;
  const auto is_alive = [&](const NeighbourWay& way) { return arrival.now - way.heard() < hold; };
  const auto is_of_source = [&](const NeighbourWay& way) { return way.source() == arrival.source; };
  const auto is_here = [&](const NeighbourWay& way) { return way.is_on(arrival.interface); };
  if ((is_contested || was_misled_) && std::ranges::any_of(ways_, is_alive)) return false;
  // Where one way is alive, no second one from the same link of ours is needed.
  const auto here = std::ranges::find_if(ways_, [&](const NeighbourWay& way) { return is_here(way) && is_alive(way); });
  if (here != ways_.end() && !is_of_source(*here)) return false;
  if (here == ways_.end() && std::ranges::any_of(ways_, is_of_source)) return true;
  // A new address, or a known address with another interface number, must say so twice, and nobody else between.
  const bool is_repeated = opening_ && opening_->interface == arrival.interface &&
                           opening_->link == announcement.link && opening_->source == arrival.source &&
                           announcement.sequence != opening_->sequence;
  opening_ = Opening{arrival.interface, announcement.link, std::string(arrival.source), announcement.sequence};
  return is_repeated;
}

NeighbourWay* NeighbourWays::open(const announcement::Announcement& announcement, const Arrival& arrival, Duration hold,
                                  bool is_contested) {
  if (ways_.size() == announcement::max_paths || !may_open(announcement, arrival, hold, is_contested)) return nullptr;
  opening_.reset();
  const auto place = std::ranges::find_if(ways_, [&](const NeighbourWay& each) {
    return std::tuple(each.interface(), each.link()) > std::tuple(arrival.interface, announcement.link);
  });
  return &*ways_.emplace(place, announcement, arrival);
}

bool NeighbourWays::close_later(const NeighbourWay& way, const Arrival& arrival) {
  if (opening_ && opening_->interface == arrival.interface) opening_.reset();
  const auto opened = way.opened();
  const auto closed = std::erase_if(ways_, [&](const NeighbourWay& each) {
    return !each.is_relayed() && each.is_on(arrival.interface) && each.source() == arrival.source &&
           each.opened() > opened;
  });
  was_misled_ |= closed > 0;
  return closed > 0;
}

bool NeighbourWays::forget_interface(env::InterfaceIndex interface) {
  if (std::erase_if(ways_, [&](const NeighbourWay& way) { return way.is_on(interface); }) == 0) return false;
  for (auto& way : ways_) {
    way.is_vouched = true;
    vouch(way.source());
  }
  return true;
}

bool NeighbourWays::expire(Instant now) {
  return std::erase_if(ways_, [now](const NeighbourWay& way) { return way.deadline <= now; }) > 0;
}

void NeighbourWays::postpone(Instant until) {
  for (auto& way : ways_) way.deadline = std::max(way.deadline, until);
}

void NeighbourWays::postpone_last(Instant until) {
  const auto last = std::ranges::max_element(ways_, {}, &NeighbourWay::heard);
  if (last != ways_.end()) last->deadline = std::max(last->deadline, until);
}

void NeighbourWays::shorten(Instant latest) {
  for (auto& way : ways_) way.deadline = std::min(way.deadline, latest);
}

bool NeighbourWays::is_from_one(const Arrival& arrival) const {
  return std::ranges::any_of(
      ways_, [&](const NeighbourWay& way) { return way.is_on(arrival.interface) && way.source() == arrival.source; });
}

void NeighbourWays::set_relayed_loss(double loss) {
  for (auto& way : ways_) {
    if (way.is_relayed()) way.set_loss(loss);
  }
}

void NeighbourWays::roll_back(Instant now, Duration hold) {
  for (auto& way : ways_) way.roll_back(now, hold);
}

void NeighbourWays::forget_parts() {
  for (auto& way : ways_) way.forget_parts();
}

void NeighbourWays::note_goodbye(const announcement::Announcement& announcement, const Arrival& arrival) {
  if (find_bound(announcement, arrival) == nullptr) return;
  auto& goodbye = find(announcement, arrival)->goodbye;
  if (!goodbye) goodbye = announcement.sequence;
}

void NeighbourWays::forget_goodbyes() {
  for (auto& way : ways_) way.goodbye.reset();
}

bool NeighbourWays::is_vouched(std::string_view source) const {
  return std::ranges::find(vouched_, without_zone(source)) != vouched_.end();
}

bool NeighbourWays::lists(const announcement::Announcement& state, std::string_view address) {
  return std::ranges::any_of(state.addresses,
                             [&](const auto& each) { return without_zone(each) == without_zone(address); });
}

void NeighbourWays::vouch(std::string_view source) {
  if (is_vouched(source)) return;
  if (vouched_.size() == announcement::max_vouched) vouched_.erase(vouched_.begin());
  vouched_.emplace_back(without_zone(source));
}

void NeighbourWays::go_on_from(env::InterfaceIndex interface, std::uint32_t link, const LossWindow& former) {
  for (NeighbourWay& way : ways_) {
    if (way.interface() == interface && way.link() == link && !way.is_relayed()) way.go_on_from(former);
  }
}

double NeighbourWays::loss() const {
  double best = ways_.empty() ? 0 : 1;
  for (const auto& way : ways_) best = std::min(best, way.loss());
  return best;
}

bool NeighbourWays::is_loss_known() const { return std::ranges::any_of(ways_, &NeighbourWay::is_loss_known); }

}  // namespace geminga::membership
