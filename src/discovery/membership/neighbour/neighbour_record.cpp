#include "discovery/membership/neighbour/neighbour_record.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {
namespace {

using base::Duration;
using base::Instant;
using Order = NeighbourWay::Order;

/// An unchanged service is refreshed at most once in this share of the interval (and this time), so that copies on
/// several interfaces and the quick copies of a change cost the caller nothing.
constexpr int refreshes_per_interval = 16;
constexpr Duration min_refresh_time = std::chrono::milliseconds(20);

}  // namespace

NeighbourRecord::Header NeighbourRecord::header_of(const announcement::Announcement& announcement) {
  return {announcement.name.empty() ? to_string(announcement.participant) : announcement.name,
          announcement.ontology_digest, announcement.interval, announcement.lasting};
}

NeighbourRecord::NeighbourRecord(const announcement::Announcement& first, const Arrival& arrival, Turn since,
                                 ServiceRoom& room, const Witnesses& witnesses)
    : id_(first.participant),
      boot_(first.boot),
      source_(arrival.source),
      since_(since),
      standing_{arrival.now, arrival.now},
      header_(header_of(first), arrival.now),
      interval_(announcement::stretched(first.interval, first.doublings), arrival.now),
      signs_(arrival.passage == nullptr ? arrival.now : arrival.now - arrival.passage->age,
             std::min(interval_.value(), announcement::stranger_interval)),
      revision_(first.revision),
      said_revision_(first.revision),
      revisions_(first.revision, arrival.now),
      services_(Owner{first.participant, header_.value().name, {}, {}}, room),
      witnesses_(witnesses) {}

Duration NeighbourRecord::lasting_interval(Instant now) const {
  const auto lasting = interval_.lasting(now);
  return standing_.is_confirmed ? lasting : std::min(lasting, announcement::stranger_interval);
}

Duration NeighbourRecord::hold(Instant now) const {
  const auto known_for = std::max<Duration>(announcement::stranger_interval, now - standing_.first);
  return announcement::hold_intervals * std::min(interval_.lasting(now), known_for);
}

double NeighbourRecord::known_loss() const { return ways_.is_loss_known() ? ways_.loss() : 0.3; }

Reception NeighbourRecord::reception(Instant now) const {
  const auto interval = lasting_interval(now);
  return {.loss = ways_.loss(), .witnesses = witnesses_.words(id_, now, interval), .delay = delay(interval)};
}

Moment NeighbourRecord::moment(Instant now, bool is_heard) const {
  return {.now = now,
          .deadline = now + service_intervals * lasting_interval(now),
          .hold = hold(now),
          .refresh = std::max(interval() / refreshes_per_interval, min_refresh_time),
          .is_contested = is_contested_,
          .is_complete = is_complete_,
          .is_heard = is_heard};
}

Order NeighbourRecord::order(const NeighbourWay& way, const announcement::Announcement& announcement,
                             const Arrival& arrival) const {
  const auto order = way.order(announcement, arrival.now);
  if (order != Order::next) return order;
  if (announcement.revision < revision_) {
    // Another way was ahead of this one. No way is behind for long.
    return revisions_.is_late(announcement.revision, arrival.now) ? Order::contradiction : Order::overtaken;
  }
  if (announcement.revision > said_revision_ || announcement.kind == announcement::Kind::presence) return order;
  const bool is_state = announcement.kind == announcement::Kind::state;
  const bool is_denied =
      (is_state && (header_of(announcement) != header_.value() || way.denies(announcement, arrival))) ||
      services_.denies(announcement, is_complete_ ? &complete_ : nullptr);
  return is_denied ? Order::contradiction : order;
}

Hearing NeighbourRecord::hear(const announcement::Announcement& announcement, const Arrival& arrival,
                              std::vector<Change>& changes) {
  const auto now = arrival.now;
  end_contest(now);
  bool is_forged = false;  // something that was believed is forged
  // A seal proves that this is the participant, which needs no relay any more.
  if (arrival.passage == nullptr && passage_ && arrival.is_sealed) ways_.close_relayed();
  auto* way = ways_.find(announcement, arrival);
  const bool is_where_it_was = way != nullptr && way->source() == arrival.source;
  if (way != nullptr) {
    const auto origin = way->origin(announcement, arrival, is_contested_, hold(now));
    if (origin == NeighbourWay::Origin::copied) return Hearing::copied;
    if (origin == NeighbourWay::Origin::elsewhere) return Hearing::elsewhere;
    is_forged = origin == NeighbourWay::Origin::back;
    if (ways_.close_later(*way, arrival)) is_forged = true;
    way = ways_.find(announcement, arrival);
  } else {
    way = ways_.open(announcement, arrival, hold(now), is_contested_);
    if (way == nullptr) return Hearing::elsewhere;
    way->deadline = now + patience(lasting_interval(now), {});
  }
  if (!is_contested_ && way->leaps(announcement, revision_)) return Hearing::leap;
  const auto order = is_forged ? Order::contradiction : this->order(*way, announcement, arrival);
  if (!is_where_it_was) meet(*way, arrival);
  if (arrival.passage != nullptr) {
    take_passage(*arrival.passage, now);
  } else {
    passage_.reset();
    heard_directly_ = now;
  }
  const bool is_copy = way->is_copy(announcement.sequence, now);
  if (std::exchange(has_spoken_, true) && !way->has(announcement.sequence)) standing_.hear(now);
  way->count(announcement, arrival, order == Order::contradiction);
  is_suspected_ = false;
  rival_.reset();
  if (order == Order::contradiction) contest(now, changes);
  if (order != Order::overtaken || is_contested_) take_in(*way, announcement, arrival, changes);
  const bool is_sign = way->is_vouched && !is_copy;
  if (is_sign) signs_.hear(arrival.passage != nullptr ? now - arrival.passage->age : now);
  set_deadlines(*way, is_sign, now);
  return order == Order::contradiction ? Hearing::contradiction : Hearing::known;
}

void NeighbourRecord::take_in(NeighbourWay& way, const announcement::Announcement& announcement, const Arrival& arrival,
                              std::vector<Change>& changes) {
  const auto now = arrival.now;
  if (announcement.kind == announcement::Kind::presence) {
    way.affirm(announcement.revision, now, is_contested_);
    if (announcement.revision == said_revision_ && !is_contested_) header_.affirm(now);
    take_interval(announcement, now);
    take_revision(way, announcement, now, changes);
  } else if (announcement.kind == announcement::Kind::change) {
    take_change(way, announcement, now, changes);
  } else {
    take_state(way, announcement, arrival);
    take_revision(way, announcement, now, changes);
    services_.apply(announcement, moment(now, true), changes);
  }
  services_.tell(moment(now, true), changes);
}

void NeighbourRecord::take_state(NeighbourWay& way, const announcement::Announcement& announcement,
                                 const Arrival& arrival) {
  const auto now = arrival.now;
  const auto held = hold(now);
  said_revision_ = announcement.revision;
  auto header = header_of(announcement);
  if (header == header_.value()) {
    header_.affirm(now);
  } else if (!is_contested_ || !header_.is_held(now, held)) {
    header_.replace(std::move(header), now, held);
    is_anew_ = true;
    services_.set_name(header_.value().name);
  }
  take_interval(announcement, now);
  if (!way.is_vouched && !is_contested_ && introduces(announcement, arrival)) {
    ways_.vouch(arrival.source);
    way.is_vouched = true;
  }
  way.say(announcement, arrival, is_contested_, held);
  if (way.is_vouched) std::ranges::for_each(way.addresses(), [this](const auto& each) { ways_.vouch(each); });
  choose_address();
}

void NeighbourRecord::take_change(NeighbourWay& way, const announcement::Announcement& announcement, Instant now,
                                  std::vector<Change>& changes) {
  const bool follows =
      !is_contested_ && announcement.since <= said_revision_ && said_revision_ <= announcement.revision;
  const bool completes = follows && is_complete_ && announcement.since <= revision_;
  way.advance(announcement.since, announcement.revision, now, is_contested_);
  if (follows) {
    said_revision_ = announcement.revision;
    header_.affirm(now);
  }
  take_interval(announcement, now);
  take_revision(way, announcement, now, changes);
  if (completes && update_services(complete_, announcement)) {
    is_complete_ = true;
    affirmed_ = now;
    held_revision_ = revision_;
  }
  services_.apply(announcement, moment(now, true), changes);
  if (!is_contested_) services_.withdraw_removed(announcement, moment(now, true), changes);
}

void NeighbourRecord::take_interval(const announcement::Announcement& announcement, Instant now) {
  interval_.say(announcement::stretched(header_.value().interval, announcement.doublings), now, hold(now),
                is_contested_);
}

void NeighbourRecord::take_revision(NeighbourWay& way, const announcement::Announcement& announcement, Instant now,
                                    std::vector<Change>& changes) {
  if (announcement.revision != revision_) {
    if (announcement.revision < revision_) revisions_.restart(announcement.revision, now);
    revisions_.rise(announcement.revision, now);
    revision_ = announcement.revision;
    is_complete_ = false;
    next_service_deadline_ = services_.earliest_deadline();
  }
  if (is_contested_) return;
  const bool is_state = announcement.kind == announcement::Kind::state;
  if (!is_complete_ && is_state && way.assemble(announcement)) {
    is_complete_ = true;
    complete_ = way.assembled();
    services_.withdraw_absent(complete_, moment(now, true), changes);
    for (auto& each : ways_.all()) each.forget_parts();
  }
  if (!is_complete_) return;
  affirmed_ = now;
  held_revision_ = revision_;
}

void NeighbourRecord::meet(NeighbourWay& way, const Arrival& arrival) {
  if (!has_spoken_ || (arrival.is_sealed && arrival.passage == nullptr)) ways_.vouch(arrival.source);
  way.is_vouched = arrival.passage != nullptr || ways_.is_vouched(arrival.source);
}

bool NeighbourRecord::introduces(const announcement::Announcement& state, const Arrival& arrival) const {
  const auto lists = [&](std::string_view address) {
    return std::ranges::any_of(state.addresses, [&](const auto& each) {
      return NeighbourWays::without_zone(each) == NeighbourWays::without_zone(address);
    });
  };
  return lists(arrival.source) && !lists(services_.owner().address);
}

void NeighbourRecord::set_deadlines(NeighbourWay& way, bool is_sign, Instant now) {
  if (is_sign) signs_.renew(lasting_interval(now), reception(now));
  way.deadline = signs_.deadline();
  // A service that is not heard of until the next datagram keeps the deadline that it had.
  next_service_deadline_ = std::min(next_service_deadline_, moment(now, false).deadline);
}

void NeighbourRecord::succeed(std::uint32_t lasting, const Arrival& arrival) {
  const bool is_same =
      (lasting != 0 && lasting == this->lasting()) || std::ranges::any_of(ways_.all(), [&](const NeighbourWay& way) {
        return way.is_on(arrival.interface) && way.source() == arrival.source;
      });
  if (!is_same || is_contested_) return;
  signs_.succeed(arrival.now, lasting_interval(arrival.now));
}

void NeighbourRecord::postpone(Instant until) {
  signs_.postpone(until);
  for (auto& way : ways_.all()) way.deadline = std::max(way.deadline, until);
}

void NeighbourRecord::contest(Instant now, std::vector<Change>& changes) {
  const bool is_first = !is_contested_;
  const auto at = moment(now, false);
  is_contested_ = true;
  contested_until_ = now + std::max(announcement::contest_intervals * interval_.lasting(now), at.hold);
  if (!is_first) return;
  contested_since_ = now;
  services_.roll_back(is_complete_ ? affirmed_ : Instant::min(), at, changes);
  for (auto& way : ways_.all()) {
    way.roll_back(now, at.hold);
    way.forget_parts();
  }
  is_anew_ |= header_.roll_back(now, at.hold);
  interval_.roll_back(now, at.hold);
  services_.set_name(header_.value().name);
  choose_address();
  is_complete_ = false;
  complete_.clear();
  // Deadlines that the lie moved are moved back.
  const auto latest = now + patience(lasting_interval(now), {.loss = ways_.loss()});
  for (auto& way : ways_.all()) way.deadline = std::min(way.deadline, latest);
  services_.shorten(moment(now, false).deadline);
  next_service_deadline_ = services_.earliest_deadline();
  next_lapse_ = now;
}

void NeighbourRecord::end_contest(Instant now) {
  if (!is_contested_ || now < contested_until_) return;
  is_contested_ = false;
  next_lapse_ = base::never;
  for (auto& way : ways_.all()) way.forget_parts();
  next_service_deadline_ = services_.earliest_deadline();
}

Hearing NeighbourRecord::hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival) {
  end_contest(arrival.now);
  if (arrival.passage == nullptr && ways_.find_bound(announcement, arrival) == nullptr) return Hearing::elsewhere;
  if (!is_contested_) return Hearing::goodbye;
  signs_.shorten(arrival.now + hold(arrival.now));
  contested_until_ = std::max(contested_until_, signs_.deadline());
  return Hearing::contradiction;
}

void NeighbourRecord::note_goodbye(const announcement::Announcement& announcement, const Arrival& arrival) {
  if (ways_.find_bound(announcement, arrival) == nullptr) return;
  auto& goodbye = ways_.find(announcement, arrival)->goodbye;
  if (!goodbye) goodbye = announcement.sequence;
}

NeighbourRecord::Proof NeighbourRecord::proof(const announcement::Announcement& announcement, const Arrival& arrival,
                                              Instant left) {
  const auto* way = ways_.find_bound(announcement, arrival);
  if (way == nullptr) {
    // The sender of a false goodbye may have moved the way before.
    way = ways_.find(announcement, arrival);
    if (way == nullptr || !way->was_of(arrival.source)) return Proof::none;
  }
  const bool is_heard = way->has(announcement.sequence);
  // A true goodbye has the highest number. A lower number may have been overtaken by it, but not for long.
  const bool is_after = way->goodbye && announcement.sequence >= *way->goodbye && !is_heard;
  if (!is_after && arrival.now - left < announcement::overtaken_time) return Proof::none;
  return is_heard ? Proof::echo : Proof::alive;
}

Duration NeighbourRecord::memory(Instant now) const { return std::max<Duration>(goodbye_memory, hold(now)); }

void NeighbourRecord::come_back(Instant now, std::vector<Change>& changes) {
  for (auto& way : ways_.all()) way.goodbye.reset();
  services_.forget_told();
  contest(now, changes);
}

bool NeighbourRecord::yields_to(const announcement::Announcement& rival, const Arrival& arrival) {
  const bool is_repeated =
      rival_ && rival_->boot == rival.boot && rival_->source == arrival.source && rival.sequence != rival_->sequence;
  const bool is_silent = arrival.now - signs_.heard() >= hold(arrival.now);
  if (is_repeated && is_silent) return true;
  rival_ = Rival{rival.boot, std::string(arrival.source), rival.sequence};
  return false;
}

void NeighbourRecord::choose_address() {
  const auto& owner = services_.owner();
  const auto chosen = best_address(ways_.all(), owner.address, owner.zone);
  if (!chosen || (chosen->address == owner.address && chosen->zone == owner.zone)) return;
  services_.set_address(chosen->address, chosen->zone);
}

void NeighbourRecord::expire(Instant now, std::vector<Change>& changes) {
  const auto lost = std::erase_if(ways_.all(), [&](const NeighbourWay& way) { return way.deadline <= now; });
  if (lost > 0) choose_address();
  if (standing_.is_confirmed) signs_.doubt(now, lasting_interval(now));
  if (is_contested_ && next_lapse_ <= now) next_lapse_ = services_.lapse(moment(now, false), changes);
  end_contest(now);
  if (!is_complete_ && next_service_deadline_ <= now) {
    services_.expire(moment(now, false), changes);
    next_service_deadline_ = services_.earliest_deadline();
  }
  services_.tell(moment(now, false), changes);
}

void NeighbourRecord::forget_interface(env::InterfaceIndex interface, std::vector<Change>& changes) {
  if (std::erase_if(ways_.all(), [&](const NeighbourWay& way) { return way.is_on(interface); }) == 0) return;
  // It is we who hear it on fewer ways: those that are left count.
  for (auto& way : ways_.all()) {
    way.is_vouched = true;
    ways_.vouch(way.source());
  }
  choose_address();
  services_.tell(moment(signs_.heard(), false), changes);
}

Instant NeighbourRecord::next_deadline() const {
  auto next = signs_.deadline();
  for (const auto& way : ways_.all()) next = std::min(next, way.deadline);
  if (standing_.is_confirmed && !signs_.is_doubted())
    next = std::min(next, signs_.doubt_due(lasting_interval(signs_.heard())));
  if (!is_complete_) next = std::min(next, next_service_deadline_);
  if (is_contested_) next = std::min({next, contested_until_, next_lapse_});
  return next;
}

Neighbour NeighbourRecord::snapshot() const {
  Neighbour neighbour;
  neighbour.id = id_;
  neighbour.boot = boot_;
  neighbour.name = header_.value().name;
  neighbour.ontology_digest = header_.value().ontology_digest;
  neighbour.interval = interval();
  neighbour.heard = signs_.heard();
  neighbour.deadline = signs_.deadline();
  neighbour.address = services_.owner().address;
  for (const auto& way : ways_.all()) neighbour.paths.push_back(way.path());
  neighbour.loss = ways_.loss();
  neighbour.publications = services_.publications();
  neighbour.subscriptions = services_.size() - neighbour.publications;
  neighbour.is_deaf = witnesses_.is_surely_deaf_to_us(id_);
  if (passage_) neighbour.through = passage_->through;
  neighbour.is_complete = is_complete_;
  return neighbour;
}

}  // namespace geminga::membership
