#include "discovery/membership/neighbour/neighbour_record.hpp"

#include <algorithm>
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

NeighbourRecord::NeighbourRecord(const announcement::Announcement& first, const Arrival& arrival, Turn since,
                                 ServiceRoom& room, const Witnesses& witnesses)
    : origin_{.id = first.participant, .boot = first.boot, .source = std::string(arrival.source), .since = since},
      standing_{arrival.now, arrival.now},
      header_(header_of(first), arrival.now),
      interval_(announcement::stretched(first.interval, first.doublings), arrival.now),
      signs_(arrival.passage == nullptr ? arrival.now : arrival.now - arrival.passage->age,
             std::min(interval_.value(), announcement::stranger_interval)),
      known_(first.revision, arrival.now),
      services_(Owner{first.participant, header().name, {}, {}}, room),
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
  return {.loss = ways_.loss(),
          .witnesses = witnesses_.words(origin_.id, now, interval),
          .delay = passage_.delay(interval)};
}

Moment NeighbourRecord::moment(Instant now) const {
  return {.now = now,
          .deadline = now + service_intervals * lasting_interval(now),
          .hold = hold(now),
          .refresh = std::max(interval() / refreshes_per_interval, min_refresh_time),
          .is_contested = contest_.is_open(),
          .is_complete = known_.is_complete(),
          .is_heard = false};
}

Moment NeighbourRecord::moment_of_hearing(Instant now) const {
  Moment moment = this->moment(now);
  moment.is_heard = true;
  return moment;
}

Order NeighbourRecord::order(const NeighbourWay& way, const announcement::Announcement& announcement,
                             const Arrival& arrival) const {
  const auto order = way.order(announcement, arrival.now);
  if (order != Order::next) return order;
  if (announcement.revision < known_.revision()) {
    // Another way was ahead of this one. No way is behind for long.
    return known_.is_late(announcement.revision, arrival.now) ? Order::contradiction : Order::overtaken;
  }
  if (announcement.revision > known_.said() || announcement.kind == announcement::Kind::presence) return order;
  const bool is_state = announcement.kind == announcement::Kind::state;
  const bool is_denied = (is_state && (header_of(announcement) != header() || way.denies(announcement, arrival))) ||
                         services_.denies(announcement, known_.services());
  return is_denied ? Order::contradiction : order;
}

Hearing NeighbourRecord::hear(const announcement::Announcement& announcement, const Arrival& arrival,
                              std::vector<Change>& changes) {
  const auto now = arrival.now;
  end_contest(now);
  bool is_forged = false;  // something that was believed is forged
  // A seal proves that this is the participant, which needs no relay any more.
  if (arrival.passage == nullptr && passage() != nullptr && arrival.is_sealed) ways_.close_relayed();
  auto* way = ways_.find(announcement, arrival);
  const bool is_where_it_was = way != nullptr && way->source() == arrival.source;
  if (way != nullptr) {
    const auto origin = way->origin(announcement, arrival, contest_.is_open(), hold(now));
    if (origin == NeighbourWay::Origin::copied) return Hearing::copied;
    if (origin == NeighbourWay::Origin::elsewhere) return Hearing::elsewhere;
    is_forged = origin == NeighbourWay::Origin::back;
    if (ways_.close_later(*way, arrival)) is_forged = true;
    way = ways_.find(announcement, arrival);
  } else {
    way = ways_.open(announcement, arrival, hold(now), contest_.is_open());
    if (way == nullptr) return Hearing::elsewhere;
    way->deadline = now + patience(lasting_interval(now), {});
  }
  if (!contest_.is_open() && way->leaps(announcement, known_.revision())) return Hearing::leap;
  const auto order = is_forged ? Order::contradiction : this->order(*way, announcement, arrival);
  if (!is_where_it_was) meet(*way, arrival);
  if (arrival.passage != nullptr) {
    passage_.hear_through(*arrival.passage, now);
  } else {
    passage_.hear_directly(now);
  }
  const bool is_copy = way->is_copy(announcement.sequence, now);
  if (std::exchange(has_spoken_, true) && !way->has(announcement.sequence)) standing_.hear(now);
  way->count(announcement, arrival, order == Order::contradiction);
  known_.set_suspected(false);
  rival_.reset();
  if (order == Order::contradiction) contest(now, changes);
  if (order != Order::overtaken || contest_.is_open()) take_in(*way, announcement, arrival, changes);
  const bool is_sign = way->is_vouched && !is_copy;
  if (is_sign) signs_.hear(arrival.passage != nullptr ? now - arrival.passage->age : now);
  set_deadlines(*way, is_sign, now);
  return order == Order::contradiction ? Hearing::contradiction : Hearing::known;
}

void NeighbourRecord::take_in(NeighbourWay& way, const announcement::Announcement& announcement, const Arrival& arrival,
                              std::vector<Change>& changes) {
  const auto now = arrival.now;
  if (announcement.kind == announcement::Kind::presence) {
    way.affirm(announcement.revision, now, contest_.is_open());
    if (announcement.revision == known_.said() && !contest_.is_open()) header_.affirm(now);
    take_interval(announcement, now);
    take_revision(way, announcement, now, changes);
  } else if (announcement.kind == announcement::Kind::change) {
    take_change(way, announcement, now, changes);
  } else {
    take_state(way, announcement, arrival);
    take_revision(way, announcement, now, changes);
    services_.apply(announcement, moment_of_hearing(now), changes);
  }
  services_.tell(moment_of_hearing(now), changes);
}

void NeighbourRecord::take_state(NeighbourWay& way, const announcement::Announcement& announcement,
                                 const Arrival& arrival) {
  const auto now = arrival.now;
  const auto held = hold(now);
  known_.say(announcement.revision);
  if (header_.say(header_of(announcement), now, held, contest_.is_open())) services_.set_name(header().name);
  take_interval(announcement, now);
  if (!way.is_vouched && !contest_.is_open() && introduces(announcement, arrival)) {
    ways_.vouch(arrival.source);
    way.is_vouched = true;
  }
  way.say(announcement, arrival, contest_.is_open(), held);
  if (way.is_vouched) std::ranges::for_each(way.addresses(), [this](const auto& each) { ways_.vouch(each); });
  choose_address();
}

void NeighbourRecord::take_change(NeighbourWay& way, const announcement::Announcement& announcement, Instant now,
                                  std::vector<Change>& changes) {
  const bool follows =
      !contest_.is_open() && announcement.since <= known_.said() && known_.said() <= announcement.revision;
  const bool completes = follows && known_.is_complete() && announcement.since <= known_.revision();
  way.advance(announcement.since, announcement.revision, now, contest_.is_open());
  if (follows) {
    known_.say(announcement.revision);
    header_.affirm(now);
  }
  take_interval(announcement, now);
  take_revision(way, announcement, now, changes);
  if (completes && known_.complete_by(announcement)) known_.affirm(now);
  services_.apply(announcement, moment_of_hearing(now), changes);
  if (!contest_.is_open()) services_.withdraw_removed(announcement, moment_of_hearing(now), changes);
}

void NeighbourRecord::take_interval(const announcement::Announcement& announcement, Instant now) {
  interval_.say(announcement::stretched(header().interval, announcement.doublings), now, hold(now), contest_.is_open());
}

void NeighbourRecord::take_revision(NeighbourWay& way, const announcement::Announcement& announcement, Instant now,
                                    std::vector<Change>& changes) {
  if (known_.believe(announcement.revision, now)) next_service_deadline_ = services_.earliest_deadline();
  if (contest_.is_open()) return;
  const bool is_state = announcement.kind == announcement::Kind::state;
  if (!known_.is_complete() && is_state && way.assemble(announcement)) {
    const auto& whole = known_.complete(way.assembled());
    services_.withdraw_absent(whole, moment_of_hearing(now), changes);
    ways_.forget_parts();
  }
  if (known_.is_complete()) known_.affirm(now);
}

void NeighbourRecord::meet(NeighbourWay& way, const Arrival& arrival) {
  if (!has_spoken_ || (arrival.is_sealed && arrival.passage == nullptr)) ways_.vouch(arrival.source);
  way.is_vouched = arrival.passage != nullptr || ways_.is_vouched(arrival.source);
}

bool NeighbourRecord::introduces(const announcement::Announcement& state, const Arrival& arrival) const {
  return NeighbourWays::lists(state, arrival.source) && !NeighbourWays::lists(state, services_.owner().address);
}

void NeighbourRecord::set_deadlines(NeighbourWay& way, bool is_sign, Instant now) {
  if (is_sign) signs_.renew(lasting_interval(now), reception(now));
  way.deadline = signs_.deadline();
  // A service that is not heard of until the next datagram keeps the deadline that it had.
  next_service_deadline_ = std::min(next_service_deadline_, moment(now).deadline);
}

void NeighbourRecord::succeed(std::uint32_t lasting, const Arrival& arrival) {
  const bool is_same = (lasting != 0 && lasting == header().lasting) || ways_.is_from_one(arrival);
  if (!is_same || contest_.is_open()) return;
  signs_.succeed(arrival.now, lasting_interval(arrival.now));
}

void NeighbourRecord::postpone(Instant until) {
  signs_.postpone(until);
  ways_.postpone(until);
}

void NeighbourRecord::contest(Instant now, std::vector<Change>& changes) {
  const auto at = moment(now);
  const auto until = now + std::max(announcement::contest_intervals * interval_.lasting(now), at.hold);
  if (!contest_.begin(now, until)) return;
  services_.roll_back(known_.is_complete() ? known_.affirmed() : Instant::min(), at, changes);
  ways_.roll_back(now, at.hold);
  ways_.forget_parts();
  header_.roll_back(now, at.hold);
  interval_.roll_back(now, at.hold);
  services_.set_name(header().name);
  choose_address();
  known_.forget();
  // Deadlines that the lie moved are moved back.
  ways_.shorten(now + patience(lasting_interval(now), {.loss = ways_.loss()}));
  services_.shorten(moment(now).deadline);
  next_service_deadline_ = services_.earliest_deadline();
}

void NeighbourRecord::end_contest(Instant now) {
  if (!contest_.end(now)) return;
  ways_.forget_parts();
  next_service_deadline_ = services_.earliest_deadline();
}

Hearing NeighbourRecord::hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival) {
  end_contest(arrival.now);
  if (arrival.passage == nullptr && ways_.find_bound(announcement, arrival) == nullptr) return Hearing::elsewhere;
  if (!contest_.is_open()) return Hearing::goodbye;
  signs_.shorten(arrival.now + hold(arrival.now));
  contest_.prolong(signs_.deadline());
  return Hearing::contradiction;
}

Duration NeighbourRecord::memory(Instant now) const { return std::max<Duration>(goodbye_memory, hold(now)); }

void NeighbourRecord::come_back(Instant now, std::vector<Change>& changes) {
  ways_.forget_goodbyes();
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

void NeighbourRecord::hear_of(const Passage& passage, std::uint64_t revision, Instant now) {
  if (contest_.is_open() || is_heard_directly(now)) return;
  passage_.hear_through(passage, now);
  ways_.set_relayed_loss(passage.loss);
  if (revision > known_.revision()) suspect();
  const auto seen = now - passage.age;
  const auto succeeded = signs_.succeeded();
  if (seen <= signs_.heard() || (succeeded && seen <= *succeeded)) return;
  standing_.hear(now);
  signs_.hear(seen);
  signs_.renew(lasting_interval(now), reception(now));
  if (known_.is_complete() && revision == known_.revision()) known_.affirm_seen(seen);
  ways_.postpone(signs_.deadline());
}

Reach NeighbourRecord::reach() const {
  return {.id = origin_.id,
          .revision = held_revision(),
          .heard = contest_.is_open() ? signs_.heard() : std::max(signs_.heard(), witnesses_.seen(origin_.id)),
          .interval = interval(),
          .loss = ways_.loss(),
          .hops = passage() ? passage()->hops : 0,
          .beyond = passage() ? passage()->interface : env::InterfaceIndex{},
          .ways = ways_.all(),
          .reachability = reachability_};
}

void NeighbourRecord::judge_reach(const JudgeReach& judge, std::vector<Change>& changes) {
  if (ways_.all().empty()) return;  // Without a way nothing is known that is new.
  const std::string& address = services_.owner().address;
  const bool is_afar = passage() != nullptr || std::ranges::all_of(ways_.all(), &NeighbourWay::is_heard_alone);
  const bool is_judged = is_afar && !address.empty();
  const auto reachability = is_judged ? judge(address, observed_address(reach())) : Reachability::reachable;
  if (reachability == reachability_) return;
  reachability_ = reachability;
  services_.set_reachable(reachability == Reachability::reachable);
  services_.tell(moment(signs_.heard()), changes);
}

void NeighbourRecord::ask_witnesses(Instant now) {
  // For a contested participant only its own datagrams count. Without a way we may not reach it, though others do.
  if (contest_.is_open() || ways_.all().empty()) return;
  if (!signs_.witness(witnesses_.seen(origin_.id), now, lasting_interval(now), reception(now))) return;
  // The way on which it was heard last is the best guess of how it can be reached.
  ways_.postpone_last(signs_.deadline());
}

void NeighbourRecord::choose_address() {
  const auto& owner = services_.owner();
  const auto chosen = best_address(ways_.all(), owner.address, owner.zone);
  if (!chosen || (chosen->address == owner.address && chosen->zone == owner.zone)) return;
  services_.set_address(chosen->address, chosen->zone);
}

void NeighbourRecord::expire(Instant now, std::vector<Change>& changes) {
  if (ways_.expire(now)) choose_address();
  if (standing_.is_confirmed) signs_.doubt(now, lasting_interval(now));
  if (contest_.is_lapse_due(now)) contest_.set_next_lapse(services_.lapse(moment(now), changes));
  end_contest(now);
  if (!known_.is_complete() && next_service_deadline_ <= now) {
    services_.expire(moment(now), changes);
    next_service_deadline_ = services_.earliest_deadline();
  }
  services_.tell(moment(now), changes);
}

void NeighbourRecord::forget_interface(env::InterfaceIndex interface, std::vector<Change>& changes) {
  if (!ways_.forget_interface(interface)) return;
  choose_address();
  services_.tell(moment(signs_.heard()), changes);
}

Instant NeighbourRecord::next_deadline() const {
  auto next = signs_.deadline();
  for (const auto& way : ways_.all()) next = std::min(next, way.deadline);
  if (standing_.is_confirmed && !signs_.is_doubted())
    next = std::min(next, signs_.doubt_due(lasting_interval(signs_.heard())));
  if (!known_.is_complete()) next = std::min(next, next_service_deadline_);
  return std::min(next, contest_.next_deadline());
}

Neighbour NeighbourRecord::snapshot() const {
  Neighbour neighbour;
  neighbour.id = origin_.id;
  neighbour.boot = origin_.boot;
  neighbour.name = header().name;
  neighbour.ontology_digest = header().ontology_digest;
  neighbour.interval = interval();
  neighbour.heard = signs_.heard();
  neighbour.deadline = signs_.deadline();
  neighbour.address = services_.owner().address;
  for (const auto& way : ways_.all()) neighbour.paths.push_back(way.path());
  neighbour.loss = ways_.loss();
  neighbour.publications = services_.publications();
  neighbour.subscriptions = services_.size() - neighbour.publications;
  neighbour.is_deaf = witnesses_.is_surely_deaf_to_us(origin_.id);
  if (passage() != nullptr) neighbour.through = passage()->through;
  neighbour.is_complete = known_.is_complete();
  return neighbour;
}

}  // namespace geminga::membership
