// Judges each datagram by its kind: who owns its identifier, and what the record of that participant takes in.
#include "discovery/membership/neighbour_table.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/greediest.hpp"

namespace geminga::membership {

using base::Instant;

Hearing NeighbourTable::hear(const announcement::Announcement& announcement, const Arrival& arrival) {
  if (announcement.group != group_) return Hearing::other_group;
  if (announcement.boot == self_boot_) return Hearing::own;
  if (announcement.participant == self_) return Hearing::clash;
  begin_datagram();
  turn_ += 2;  // odd numbers are for claims that were overtaken
  switch (announcement.kind) {
    case announcement::Kind::claim:
      return hear_claim(announcement, arrival);
    case announcement::Kind::goodbye:
      return hear_goodbye(announcement, arrival);
    case announcement::Kind::presence:
    case announcement::Kind::change:
      return hear_short(announcement, arrival);
    case announcement::Kind::inquiry:
    case announcement::Kind::diagnosis:
    case announcement::Kind::relayed:
      return Hearing::stale;  // they say nothing of their sender's state, and are taken in elsewhere
    case announcement::Kind::state:
      break;
  }
  const auto hearing = hear_state(announcement, arrival);
  if (hearing == Hearing::newcomer || hearing == Hearing::returned) {
    lacks_and_doubts_.forget_stranger(announcement.participant);
  }
  return hearing;
}

std::size_t NeighbourTable::expire(Instant now) {
  std::size_t lost = 0;
  claims_.prune(now);
  if (timetable_.next() > now) return lost;
  std::size_t count = 0;
  for (const auto id : timetable_.due(now)) {
    if (++count > max_expired_at_once) break;
    const auto known = records_.find(id);
    known->second.record->ask_witnesses(now);
    if (known->second.record->signs().deadline() <= now) {
      lost += known->second.record->is_sought(now) ? 1 : 0;
      former_losses_.remember(id, *known->second.record);
      former_.remember_expired(remove(known, Departure::expired), now);
    } else {
      known->second.record->expire(now, changes_);
      update(*known, now);
    }
  }
  return lost;
}

std::size_t NeighbourTable::shed(Instant now) {
  const auto newest = admission_.newest_unseasoned((records_.size() - admission_.seasoned() + 3) / 4);
  for (const auto id : newest) displace(id);
  former_.shed();
  room_ = records_.size();
  room_until_ = now + memory_pause;
  return newest.size();
}

void NeighbourTable::postpone(Instant until) {
  witnesses_.distrust_until(until);
  for (auto& known : records_) {
    known.second.record->postpone(until);
    update(known, until);
  }
}

Report NeighbourTable::report(Instant now) {
  Report report;
  report.witness = witnesses_.say(now);
  lacks_and_doubts_.name(records_, now, report);
  for (const auto id : report.doubts) update(*records_.find(id), now);
  return report;
}

bool NeighbourTable::hear_doubts(const std::vector<ParticipantId>& doubts, Instant now) {
  const auto ours = lacks_and_doubts_.doubted();
  std::size_t shared = 0;
  for (const auto id : ours) {
    if (std::ranges::find(doubts, id) == doubts.end()) continue;
    const auto known = records_.find(id);
    known->second.record->ask(now);
    update(*known, now);
    ++shared;
  }
  return shared == ours.size();
}

void NeighbourTable::forget_interface(env::InterfaceIndex interface) {
  for (auto& known : records_) {
    known.second.record->forget_interface(interface, changes_);
    update(known, known.second.record->signs().heard());
  }
}

void NeighbourTable::set_self(ParticipantId id, announcement::BootNonce boot) {
  self_ = id;
  self_boot_ = boot;
  witnesses_.set_self(id, boot);
}

Difference NeighbourTable::compare(const announcement::Announcement& presence, Instant now) {
  const auto difference = witnesses_.compare(presence, now);
  if (difference.newer) {
    const auto known = records_.find(*difference.newer);
    known->second.record->suspect();
    update(*known, now);
  }
  return difference;
}

Hearing NeighbourTable::hear_short(const announcement::Announcement& announcement, const Arrival& arrival) {
  const auto holder = records_.find(announcement.participant);
  if (holder == records_.end() || holder->second.record->origin().boot != announcement.boot) {
    lacks_and_doubts_.hear_stranger(announcement.participant, arrival.now);
    former_losses_.hear(announcement, arrival);
    return Hearing::stranger;
  }
  auto& record = *holder->second.record;
  const bool is_new = record.is_bound(announcement, arrival);  // a copy is no news
  const auto hearing = record.hear(announcement, arrival, changes_);
  admission_.update(*holder->second.member, record.standing());
  update(*holder, arrival.now);
  if (is_new && hearing == Hearing::known && arrival.passage == nullptr && witnesses_.hear(announcement, arrival.now)) {
    for (const auto id : std::set(lacks_and_doubts_.doubted())) {  // others are looked up at their deadline
      const auto known = records_.find(id);
      known->second.record->ask_witnesses(arrival.now);
      update(*known, arrival.now);
    }
  }
  return hearing;
}

Hearing NeighbourTable::hear_claim(const announcement::Announcement& announcement, const Arrival& arrival) {
  if (former_.find(announcement, arrival.now) != nullptr) return Hearing::stale;
  const auto holder = records_.find(announcement.participant);
  if (holder == records_.end()) {
    claims_.hear(announcement, arrival.source, arrival.now, turn_);
    succeed(announcement, arrival);
    return Hearing::claim;
  }
  // A claim of an owned identifier does not give it to the claimant, except if the owner's state is an answer that
  // overtook the claim: a participant that did not claim an identifier cannot have had it before.
  const auto& record = *holder->second.record;
  const bool is_recent = arrival.now - record.standing().first < announcement::overtaken_time;
  const bool is_own = record.origin().boot == announcement.boot && record.origin().source == arrival.source;
  if (is_recent && !is_own) claims_.hear(announcement, arrival.source, arrival.now, record.origin().since - 1);
  return Hearing::claim;
}

void NeighbourTable::succeed(const announcement::Announcement& newcomer, const Arrival& arrival) {
  for (const auto id : namesakes_.find({newcomer.name, std::string(arrival.source)}, newcomer.lasting)) {
    auto& known = *records_.find(id);
    if (known.second.record->origin().boot == newcomer.boot) continue;  // the same incarnation under another identifier
    known.second.record->succeed(newcomer.lasting, arrival);
    update(known, arrival.now);
  }
}

Hearing NeighbourTable::hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival) {
  if (former_.find(announcement, arrival.now) != nullptr) former_.hear_goodbye(announcement, arrival);
  const auto known = records_.find(announcement.participant);
  if (known == records_.end() || known->second.record->origin().boot != announcement.boot) return Hearing::stale;
  const auto hearing = known->second.record->hear_goodbye(announcement, arrival);
  if (hearing == Hearing::goodbye) {
    former_.remember(remove(known, Departure::left), arrival.now);
    former_.hear_goodbye(announcement, arrival);
  } else {
    update(*known, arrival.now);
  }
  return hearing;
}

Hearing NeighbourTable::hear_state(const announcement::Announcement& announcement, const Arrival& arrival) {
  const auto holder = records_.find(announcement.participant);
  if (holder != records_.end() && holder->second.record->origin().boot == announcement.boot) {
    return hear_holder(holder, announcement, arrival);
  }
  auto since = claims_.find(announcement, arrival.source, arrival.now);
  std::optional<Instant> succeeded;
  const auto* former = former_.find(announcement, arrival.now);
  if (former != nullptr && since && *since < former->origin().since) {
    // Somebody at another address used the claimant's identifier and boot nonce before its first state, and left.
    (void)former_.take(announcement);
    former = nullptr;
  } else if (former != nullptr) {
    const bool is_expired = former_.is_expired(announcement);
    former = former_.find_alive(announcement, arrival);
    if (former == nullptr && !is_expired) return Hearing::stale;
    if (former != nullptr) since = former->origin().since;
    if (is_expired && !former_.find(announcement, arrival.now)->ways().is_vouched(arrival)) return Hearing::elsewhere;
    if (is_expired) {
      // It begins anew, but keeps its right to the identifier. Its next incarnation is not looked for again so soon.
      succeeded = former_.take(announcement)->signs().succeeded();
      former = nullptr;
    }
  }
  if (holder != records_.end()) {
    const bool is_first = since && *since < holder->second.record->origin().since;
    if (!is_first && !holder->second.record->yields_to(announcement, arrival)) return Hearing::rival;
  } else if (former != nullptr && records_.size() >= room(arrival.now)) {
    const auto gives_way = admission_.decide_return(former->origin().source, former->standing(), arrival.now);
    if (!gives_way) return Hearing::full;
    displace(*gives_way);
  }
  auto returned = former != nullptr ? former_.take(announcement) : nullptr;
  if (holder != records_.end()) former_.remember(remove(holder, Departure::expired), arrival.now);
  if (!returned) {
    const auto hearing = hear_newcomer(announcement, arrival, since.value_or(turn_));
    const auto known = records_.find(announcement.participant);
    if (known != records_.end()) known->second.record->set_succeeded(succeeded);
    return hearing;
  }
  returned->come_back(arrival.now, changes_);
  add(std::move(returned), announcement, arrival);
  return Hearing::returned;
}

Hearing NeighbourTable::hear_holder(Records::iterator holder, const announcement::Announcement& announcement,
                                    const Arrival& arrival) {
  auto& record = *holder->second.record;
  const auto hearing = record.hear(announcement, arrival, changes_);
  const auto since = hearing == Hearing::known ? std::nullopt : claims_.find(announcement, arrival.source, arrival.now);
  if (since && *since < record.origin().since) {
    // Somebody at another address used the claimant's identifier and boot nonce before its first state.
    (void)remove(holder, Departure::expired);
    return hear_newcomer(announcement, arrival, *since);
  }
  admission_.update(*holder->second.member, record.standing());
  update(*holder, arrival.now);
  return hearing;
}

Hearing NeighbourTable::hear_newcomer(const announcement::Announcement& announcement, const Arrival& arrival,
                                      Turn since) {
  std::optional<Standing> standing;
  if (records_.size() >= room(arrival.now)) {
    const auto decision = admission_.decide(announcement, arrival.source, arrival.now);
    if (!decision.gives_way) return Hearing::full;
    standing = decision.standing;
    displace(*decision.gives_way);
  }
  succeed(announcement, arrival);
  ServiceRoom& room = *this;
  auto record = std::make_unique<NeighbourRecord>(announcement, arrival, since, room, witnesses_);
  if (standing) record->set_standing(*standing);
  add(std::move(record), announcement, arrival);
  return Hearing::newcomer;
}

void NeighbourTable::add(std::unique_ptr<NeighbourRecord> one, const announcement::Announcement& announcement,
                         const Arrival& arrival) {
  const auto id = announcement.participant;
  auto& record = *one;
  const auto known = records_.add(id, {.record = std::move(one),
                                       .slot = timetable_.take(id),
                                       .member = &admission_.add(id, record.origin().source, record.standing())});
  witnesses_.add(id, record.origin().boot);
  namesakes_.update(id, {record.header().name, record.origin().source}, record.header().lasting);
  (void)record.hear(announcement, arrival, changes_);
  former_losses_.hand_to(id, record);
  admission_.update(*known->second.member, record.standing());
  update(*known, arrival.now);
}

void NeighbourTable::displace(ParticipantId id) {
  const auto record = remove(records_.find(id), Departure::expired);
  admission_.remember(id, record->origin().boot, record->ways().newest(), record->standing());
}

std::unique_ptr<NeighbourRecord> NeighbourTable::remove(Records::iterator known, Departure reason) {
  changes_.emplace_back(RemoveParticipant{known->first, reason});
  admission_.remove(known->first);
  timetable_.give(known->second.slot);
  lacks_and_doubts_.forget(known->first);
  auto record = std::move(known->second.record);
  witnesses_.remove(known->first);
  namesakes_.remove(known->first);
  records_.erase(known);
  return record;
}

void NeighbourTable::update(Records::value_type& known, Instant now) {
  auto& record = *known.second.record;
  lacks_and_doubts_.update(known.first, record, now);
  if (record.take_anew()) {
    namesakes_.update(known.first, {record.header().name, record.origin().source}, record.header().lasting);
    records_.note_change();
  }
  witnesses_.update(known.first, record.signs().heard(), record.lasting_interval(now), record.held_revision());
  if (judge_) record.judge_reach(judge_, changes_);
  records_.count(known.second);
  timetable_.set(known.second.slot, record.next_deadline());
}

bool NeighbourTable::make_room(ParticipantId asks) {
  if (former_.give_way()) return true;
  const auto known = records_.find(asks);
  // A stranger is given nothing.
  if (known == records_.end() || !known->second.record->standing().is_confirmed) return false;
  auto* greediest = find_greediest(records_, admission_, *known->second.record);
  if (greediest == nullptr || !greediest->services().give_way(changes_)) return false;
  lacks_and_doubts_.note_short(greediest->origin().id);
  return true;
}

}  // namespace geminga::membership
