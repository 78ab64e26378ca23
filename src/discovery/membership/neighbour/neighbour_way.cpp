#include "discovery/membership/neighbour/neighbour_way.hpp"

#include <utility>

#include "base/address.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::membership {
namespace {

using base::Duration;
using base::Instant;

/// The addresses of a sender as they are used here: IPv6 link-local ones get our interface as zone.
std::vector<std::string> usable(const announcement::Announcement& announcement, const Arrival& arrival) {
  std::vector<std::string> addresses;
  const auto add = [&](std::string_view text) {
    auto address = base::parse_address(text);
    if (!address) return;
    const bool is_of_link = address->scope() == base::AddressScope::link_local;
    if (is_of_link && arrival.passage != nullptr) return;  // It cannot be reached beyond its own link.
    const bool needs_zone = address->is_ipv6() && is_of_link;
    address->zone = needs_zone ? std::string(arrival.interface_name) : std::string();
    addresses.push_back(address->text());
  };
  for (const auto& address : announcement.addresses) add(address);
  if (addresses.empty()) add(arrival.source);
  return addresses;
}

}  // namespace

NeighbourWay::NeighbourWay(const announcement::Announcement& first, const Arrival& arrival)
    : is_relayed_(arrival.passage != nullptr),
      is_heard_alone_(arrival.is_alone),
      opened_(arrival.now),
      source_(arrival.source),
      addresses_(usable(first, arrival), arrival.now),
      sequences_(first.sequence, arrival.now),
      revision_(first.revision),
      said_revision_(first.kind == announcement::Kind::state ? std::optional(first.revision) : std::nullopt),
      part_count_(first.part_count) {
  path_.interface = arrival.interface;
  path_.interface_name = arrival.interface_name;
  path_.link = first.link;
  path_.heard = arrival.now;
  if (is_relayed_) path_.loss = arrival.passage->loss;
}

NeighbourWay::Origin NeighbourWay::origin(const announcement::Announcement& announcement, const Arrival& arrival,
                                          bool needs_silence, Duration hold) {
  if (arrival.source == source_ || is_relayed_) {
    source_ = arrival.source;
    mover_.reset();
    return Origin::bound;
  }
  if (home_ && arrival.source == home_->source) {
    const bool may_be_overtaken = arrival.now - home_->left < announcement::overtaken_time;
    if (announcement.sequence <= home_->sequence && may_be_overtaken) return Origin::copied;
    // Its present addresses count no more than those of that time: the source address may be forged, too.
    source_ = std::move(home_->source);
    addresses_ = std::move(home_->addresses);
    home_.reset();
    mover_.reset();
    has_moved_ = false;
    was_misled_ = true;
    return Origin::back;
  }
  const bool is_silent = arrival.now - path_.heard >= hold;
  if (has(announcement.sequence) || (!is_next(announcement.sequence) && !is_silent)) return Origin::copied;
  if (!mover_ || mover_->source != arrival.source) {
    mover_ = Mover{std::string(arrival.source), announcement.sequence};
    return Origin::elsewhere;
  }
  if (announcement.sequence == mover_->sequence) return Origin::copied;
  mover_->sequence = announcement.sequence;
  // The bound address has said nothing since: that would have reset `mover_`.
  if ((needs_silence || was_misled_) && !is_silent) return Origin::elsewhere;
  move(arrival, hold);
  return Origin::bound;
}

void NeighbourWay::move(const Arrival& arrival, Duration hold) {
  // The address that the way had for long stays its home, however often it moves.
  const bool is_settled = !home_ || arrival.now - home_->left >= hold;
  if (is_settled) home_ = Home{source_, losses_.newest(), arrival.now, addresses_};
  source_ = arrival.source;
  mover_.reset();
  has_moved_ = true;
}

NeighbourWay::Order NeighbourWay::order(const announcement::Announcement& announcement, Instant now) const {
  if (losses_.is_empty()) return Order::next;
  const auto newest = losses_.newest();
  if (announcement.sequence >= newest) {
    // A sender's revision never falls, and a datagram has one number.
    return announcement.revision < revision_ ? Order::contradiction : Order::next;
  }
  const bool is_late = sequences_.is_late(announcement.sequence, now);
  if (losses_.has(announcement.sequence) && !is_late) return Order::overtaken;
  if (announcement.revision > revision_) return Order::contradiction;
  if (announcement.revision == revision_) return Order::next;
  return is_late ? Order::contradiction : Order::overtaken;
}

bool NeighbourWay::leaps(const announcement::Announcement& announcement, std::uint64_t believed) {
  if (announcement.revision <= believed || announcement.revision - believed <= announcement::max_revision_step) {
    leap_.reset();
    return false;
  }
  if (leap_ && announcement.sequence > *leap_) return false;
  leap_ = announcement.sequence;
  return true;
}

bool NeighbourWay::denies(const announcement::Announcement& announcement, const Arrival& arrival) const {
  if (losses_.is_empty() || has_moved_ || announcement.revision != said_revision_) return false;
  return announcement.part_count != part_count_.value_or(announcement.part_count) ||
         usable(announcement, arrival) != addresses_.value();
}

void NeighbourWay::count(const announcement::Announcement& announcement, const Arrival& arrival,
                         bool is_contradiction) {
  const auto sequence = announcement.sequence;
  const bool is_lower = !is_next(sequence) && sequence != losses_.newest();
  // A datagram that comes so late was not overtaken: its number is where its sender is.
  if (is_lower && (is_contradiction || sequences_.is_late(sequence, arrival.now))) {
    losses_.restart(sequence);
    sequences_.restart(sequence, arrival.now);
  } else {
    losses_.count(sequence);
    sequences_.rise(sequence, arrival.now);
  }
  is_heard_alone_ = is_heard_alone_ && arrival.is_alone;
  path_.heard = arrival.now;
  path_.interface = arrival.interface;
  path_.interface_name = arrival.interface_name;
  // The numbers of a relayed way have gaps where presences were, which a relay does not pass on.
  if (!is_relayed_) path_.loss = losses_.loss();
}

void NeighbourWay::say(const announcement::Announcement& announcement, const Arrival& arrival, bool is_contested,
                       Duration hold) {
  revision_ = announcement.revision;
  said_revision_ = announcement.revision;
  part_count_ = announcement.part_count;
  const bool is_free = std::exchange(has_moved_, false) || !is_contested || !addresses_.is_held(arrival.now, hold);
  auto addresses = usable(announcement, arrival);
  if (addresses == addresses_.value()) {
    addresses_.affirm(arrival.now);
  } else if (is_free) {
    addresses_.replace(std::move(addresses), arrival.now, hold);
  }
}

Path NeighbourWay::path() const {
  auto path = path_;
  path.addresses = addresses_.value();
  if (!is_relayed_) {
    path.lately = losses_.lately();
    path.for_long = losses_.for_long();
  }
  return path;
}

void NeighbourWay::roll_back(Instant now, Duration hold) {
  addresses_.roll_back(now, hold);
  if (home_) home_->addresses.roll_back(now, hold);
}

std::optional<ZonedAddress> best_address(std::span<const NeighbourWay> ways, std::string_view in_use,
                                         std::string_view zone) {
  // (rank, not in use): the first of the smallest is chosen.
  using Preference = std::pair<int, bool>;
  std::optional<ZonedAddress> chosen;
  Preference best{};
  for (const auto& way : ways) {
    for (const auto& text : way.addresses()) {
      const auto address = base::parse_address(text);
      if (!address) continue;
      const Preference preference{base::address_rank(*address), text != in_use || way.interface_name() != zone};
      if (chosen && best <= preference) continue;
      best = preference;
      chosen = ZonedAddress{text, way.interface_name()};
    }
  }
  return chosen;
}

}  // namespace geminga::membership
