// Which datagrams count, and for whom; what they say is taken in by the participant's record.
#include "discovery/membership/neighbour_table.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/admission.hpp"
#include "discovery/membership/claims.hpp"
#include "discovery/membership/former_lives.hpp"
#include "discovery/membership/greediest.hpp"
#include "discovery/membership/names.hpp"
#include "discovery/membership/neighbour_record.hpp"
#include "discovery/membership/questions.hpp"
#include "discovery/membership/records.hpp"
#include "discovery/membership/timetable.hpp"
#include "discovery/membership/witnesses.hpp"

namespace geminga::membership {

using base::Instant;

class NeighbourTable::State final : private ServiceRoom {
 public:
  State(std::string group, bool tells_affirmed) : ServiceRoom(tells_affirmed), group_(std::move(group)) {}

  Hearing hear(const announcement::Announcement& announcement, const Arrival& arrival) {
    if (announcement.group != group_) return Hearing::other_group;
    if (announcement.boot == self_boot_) return Hearing::own;
    if (announcement.participant == self_) return Hearing::clash;
    is_room_sought_ = false;
    turn_ += 2;  // the odd ones are for what was overtaken
    switch (announcement.kind) {
      case announcement::Kind::claim:
        return hear_claim(announcement, arrival);
      case announcement::Kind::goodbye:
        return hear_goodbye(announcement, arrival);
      case announcement::Kind::presence:
      case announcement::Kind::change:
        return hear_short(announcement, arrival);
      case announcement::Kind::state:
        break;
    }
    const auto hearing = hear_state(announcement, arrival);
    if (hearing == Hearing::newcomer || hearing == Hearing::returned) {
      questions_.forget_stranger(announcement.participant);
    }
    return hearing;
  }

  std::size_t expire(Instant now) {
    std::size_t lost = 0;
    if (timetable_.next() > now) return lost;
    for (const auto id : timetable_.due(now)) {
      const auto known = records_.find(id);
      known->second.record->ask_witnesses(now);
      if (known->second.record->deadline() <= now) {
        lost += known->second.record->is_sought(now) ? 1 : 0;
        former_.remember_expired(remove(known, Departure::expired), now);
      } else {
        known->second.record->expire(now, changes);
        set_due(*known, now);
      }
    }
    return lost;
  }

  void postpone(Instant until) {
    witnesses_.distrust_until(until);
    for (auto& known : records_) {
      known.second.record->postpone(until);
      set_due(known, until);
    }
  }

  Report report(Instant now) {
    Report report;
    report.witness = witnesses_.say(now);
    questions_.name(records_, now, report);
    for (const auto id : report.doubts) set_due(*records_.find(id), now);
    return report;
  }

  bool lacks_anybody(Instant now) { return questions_.lacks_anybody(now); }
  [[nodiscard]] bool doubts_anybody() const { return questions_.doubts_anybody(); }

  bool hear_doubts(const std::vector<ParticipantId>& doubts, Instant now) {
    const auto ours = questions_.doubted();
    std::size_t shared = 0;
    for (const auto id : ours) {
      if (std::ranges::find(doubts, id) == doubts.end()) continue;
      const auto known = records_.find(id);
      known->second.record->ask(now);
      set_due(*known, now);
      ++shared;
    }
    return shared == ours.size();
  }

  [[nodiscard]] std::optional<double> loss() const { return records_.loss(); }

  void forget_interface(env::InterfaceIndex interface) {
    for (auto& known : records_) {
      known.second.record->forget_interface(interface, changes);
      set_due(known, known.second.record->heard());
    }
  }

  void set_self(ParticipantId id, announcement::BootNonce boot) {
    self_ = id;
    self_boot_ = boot;
    witnesses_.set_self(id, boot);
  }

  void set_secret(std::uint64_t secret) { admission_.set_secret(secret); }

  [[nodiscard]] Instant next_deadline() const { return timetable_.next(); }
  [[nodiscard]] const NeighbourRecord* find(ParticipantId id) const { return records_.record(id); }
  void for_each(const std::function<void(const Neighbour&)>& visit) const {
    for (const auto& [id, known] : records_) visit(known.record->snapshot());
  }
  [[nodiscard]] std::size_t size() const { return records_.size(); }
  [[nodiscard]] std::size_t seasoned() const { return admission_.seasoned(); }
  [[nodiscard]] std::uint64_t roster() const { return roster_; }
  [[nodiscard]] Witnesses& witnesses() { return witnesses_; }
  using ServiceRoom::refused;

  std::vector<Change> changes;

 private:
  /// What says something of a state that is known, or is not.
  Hearing hear_short(const announcement::Announcement& announcement, const Arrival& arrival) {
    const auto holder = records_.find(announcement.participant);
    if (holder == records_.end() || holder->second.record->boot() != announcement.boot) {
      questions_.hear_stranger(announcement.participant, arrival.now);
      return Hearing::stranger;
    }
    auto& record = *holder->second.record;
    const bool is_new = record.is_bound(announcement, arrival);  // a copy says nothing of the present
    const auto hearing = record.hear(announcement, arrival, changes);
    admission_.update(*holder->second.place, record.standing());
    set_due(*holder, arrival.now);
    if (is_new && hearing == Hearing::known && witnesses_.hear(announcement, arrival.now)) {
      for (const auto id : std::set(questions_.doubted())) {  // all others look it up when their deadline comes
        const auto known = records_.find(id);
        known->second.record->ask_witnesses(arrival.now);
        set_due(*known, arrival.now);
      }
    }
    return hearing;
  }

  Hearing hear_claim(const announcement::Announcement& announcement, const Arrival& arrival) {
    if (former_.find(announcement, arrival.now) != nullptr) return Hearing::stale;
    const auto holder = records_.find(announcement.participant);
    if (holder == records_.end()) {
      claims_.hear(announcement, arrival, turn_);
      succeed(announcement, arrival);
      return Hearing::claim;
    }
    // One of an identifier that somebody has is no reason to give it to the claimant, unless it was overtaken by an
    // answer to itself: who has not claimed an identifier cannot have had it before.
    const auto& record = *holder->second.record;
    const bool is_recent = arrival.now - record.standing().first < announcement::overtaken_time;
    const bool is_own = record.boot() == announcement.boot && record.source() == arrival.source;
    if (is_recent && !is_own) claims_.hear(announcement, arrival, record.since() - 1);
    return Hearing::claim;
  }

  /// Whoever of this name was at this address, or has this lasting identity, may have been started again.
  void succeed(const announcement::Announcement& newcomer, const Arrival& arrival) {
    for (const auto id : names_.find({newcomer.name, std::string(arrival.source)}, newcomer.lasting)) {
      auto& known = *records_.find(id);
      if (known.second.record->boot() == newcomer.boot) continue;  // it only takes another identifier
      known.second.record->succeed(newcomer.lasting, arrival);
      set_due(known, arrival.now);
    }
  }

  Hearing hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival) {
    if (former_.find(announcement, arrival.now) != nullptr) former_.hear_goodbye(announcement, arrival);
    const auto known = records_.find(announcement.participant);
    if (known == records_.end() || known->second.record->boot() != announcement.boot) return Hearing::stale;
    const auto hearing = known->second.record->hear_goodbye(announcement, arrival);
    if (hearing == Hearing::goodbye) {
      former_.remember(remove(known, Departure::left), arrival.now);
      former_.hear_goodbye(announcement, arrival);
    } else {
      set_due(*known, arrival.now);
    }
    return hearing;
  }

  /// Whose an identifier is: ANNOUNCEMENT.md, "Whose an identifier is".
  Hearing hear_state(const announcement::Announcement& announcement, const Arrival& arrival) {
    const auto holder = records_.find(announcement.participant);
    if (holder != records_.end() && holder->second.record->boot() == announcement.boot) {
      return hear_holder(holder, announcement, arrival);
    }
    auto since = claims_.find(announcement, arrival);
    std::optional<Instant> succeeded;
    const auto* former = former_.find(announcement, arrival.now);
    if (former != nullptr && since && *since < former->since()) {
      // Somebody at another address has anticipated the claimant's first state, and left.
      (void)former_.take(announcement);
      former = nullptr;
    } else if (former != nullptr) {
      const bool is_expired = former_.is_expired(announcement);
      former = former_.find_alive(announcement, arrival);
      if (former == nullptr && !is_expired) return Hearing::stale;
      if (former != nullptr) since = former->since();
      if (is_expired) {
        // It begins anew, but keeps its right to the identifier, and its next life is not looked for again so soon.
        succeeded = former_.take(announcement)->succeeded();
        former = nullptr;
      }
    }
    if (holder != records_.end()) {
      const bool is_first = since && *since < holder->second.record->since();
      if (!is_first && !holder->second.record->yields_to(announcement, arrival)) return Hearing::rival;
    } else if (former != nullptr && records_.size() == announcement::max_participants) {
      const auto gives_way = admission_.decide_return(former->source(), former->standing(), arrival.now);
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
    returned->come_back(arrival.now, changes);
    add(std::move(returned), announcement, arrival);
    return Hearing::returned;
  }

  Hearing hear_holder(Records::iterator holder, const announcement::Announcement& announcement,
                      const Arrival& arrival) {
    auto& record = *holder->second.record;
    const auto hearing = record.hear(announcement, arrival, changes);
    const auto since = hearing == Hearing::known ? std::nullopt : claims_.find(announcement, arrival);
    if (since && *since < record.since()) {
      // Somebody at another address anticipated the claimant's first state, with its boot nonce.
      (void)remove(holder, Departure::expired);
      return hear_newcomer(announcement, arrival, *since);
    }
    admission_.update(*holder->second.place, record.standing());
    set_due(*holder, arrival.now);
    return hearing;
  }

  Hearing hear_newcomer(const announcement::Announcement& announcement, const Arrival& arrival, Turn since) {
    std::optional<Standing> standing;
    if (records_.size() == announcement::max_participants) {
      const auto decision = admission_.decide(announcement, arrival);
      if (!decision.gives_way) return Hearing::full;
      standing = decision.standing;
      displace(*decision.gives_way);
    }
    succeed(announcement, arrival);
    auto record = std::make_unique<NeighbourRecord>(announcement, arrival, since, room(), witnesses_);
    if (standing) record->set_standing(*standing);
    add(std::move(record), announcement, arrival);
    return Hearing::newcomer;
  }

  void add(std::unique_ptr<NeighbourRecord> one, const announcement::Announcement& announcement,
           const Arrival& arrival) {
    const auto id = announcement.participant;
    auto& record = *one;
    const auto known = records_.add(id, {.record = std::move(one),
                                         .slot = timetable_.take(id),
                                         .place = &admission_.add(id, record.source(), record.standing())});
    ++roster_;
    witnesses_.add(id, record.boot());
    names_.update(id, {record.name(), record.source()}, record.lasting());
    (void)record.hear(announcement, arrival, changes);
    admission_.update(*known->second.place, record.standing());
    set_due(*known, arrival.now);
  }

  ServiceRoom& room() { return *this; }

  void displace(ParticipantId id) {
    const auto record = remove(records_.find(id), Departure::expired);
    admission_.remember(id, record->boot(), record->newest(), record->standing());
  }

  std::unique_ptr<NeighbourRecord> remove(Records::iterator known, Departure reason) {
    changes.emplace_back(RemoveParticipant{known->first, reason});
    admission_.remove(known->first);
    timetable_.give(known->second.slot);
    ++roster_;
    questions_.forget(known->first);
    auto record = std::move(known->second.record);
    witnesses_.remove(known->first);
    names_.remove(known->first);
    records_.erase(known);
    return record;
  }

  void set_due(Records::value_type& known, Instant now) {
    auto& record = *known.second.record;
    questions_.update(known.first, record, now);
    if (record.take_anew()) {
      names_.update(known.first, {record.name(), record.source()}, record.lasting());
      ++roster_;
    }
    witnesses_.update(known.first, record.heard(), record.interval());
    records_.count(known.second);
    timetable_.set(known.second.slot, record.next_deadline());
  }

  // A stranger is given nothing.
  bool make_room(const NeighbourServices& who) override {
    if (std::exchange(is_room_sought_, true) && !was_room_found_) return false;
    was_room_found_ = former_.give_way();
    if (was_room_found_) return true;
    const auto asks = records_.find(who.owner().id);
    if (asks == records_.end() || !asks->second.record->standing().is_confirmed) return false;
    auto* greediest = find_greediest(records_, admission_, *asks->second.record);
    was_room_found_ = greediest != nullptr && greediest->services().give_way(changes);
    if (was_room_found_) questions_.note_short(greediest->services().owner().id);
    return was_room_found_;
  }

  std::string group_;
  ParticipantId self_{};
  announcement::BootNonce self_boot_{};
  Admission admission_;
  Witnesses witnesses_;
  FormerLives former_;
  Claims claims_;
  Questions questions_;
  Names names_;
  Turn turn_ = 0;
  Records records_;
  Timetable timetable_;          ///< when expire() has something to do for whom
  std::uint64_t roster_ = 0;     ///< counts changes of who is known
  bool is_room_sought_ = false;  ///< for the datagram that is being taken in
  bool was_room_found_ = false;
};

NeighbourTable::NeighbourTable(std::string group, Affirmed affirmed)
    : state_(std::make_unique<State>(std::move(group), affirmed == Affirmed::told)) {}
NeighbourTable::~NeighbourTable() = default;

void NeighbourTable::set_self(ParticipantId id, announcement::BootNonce boot) { state_->set_self(id, boot); }
void NeighbourTable::set_secret(std::uint64_t secret) { state_->set_secret(secret); }
Hearing NeighbourTable::hear(const announcement::Announcement& announcement, const Arrival& arrival) {
  return state_->hear(announcement, arrival);
}
std::size_t NeighbourTable::expire(base::Instant now) { return state_->expire(now); }
void NeighbourTable::postpone(base::Instant until) { state_->postpone(until); }
Report NeighbourTable::report(base::Instant now) { return state_->report(now); }
bool NeighbourTable::lacks_anybody(base::Instant now) { return state_->lacks_anybody(now); }
bool NeighbourTable::doubts_anybody() const { return state_->doubts_anybody(); }
Unknown NeighbourTable::compare(const announcement::Announcement& presence, base::Instant now) {
  return state_->witnesses().compare(presence, now);
}
bool NeighbourTable::is_unlike(base::Instant now) const { return state_->witnesses().is_unlike(now); }
bool NeighbourTable::misses_us(const announcement::Announcement& presence, base::Instant since, base::Duration interval,
                               base::Instant now) {
  return state_->witnesses().misses_us(presence, since, interval, now);
}

bool NeighbourTable::is_heard_lately(ParticipantId id, base::Instant now) const {
  return state_->witnesses().has_heard(id, now);
}

bool NeighbourTable::hear_doubts(const std::vector<ParticipantId>& doubts, base::Instant now) {
  return state_->hear_doubts(doubts, now);
}
std::optional<double> NeighbourTable::loss() const { return state_->loss(); }
base::Instant NeighbourTable::next_deadline() const { return state_->next_deadline(); }
void NeighbourTable::forget_interface(env::InterfaceIndex interface) { state_->forget_interface(interface); }
std::vector<Change> NeighbourTable::take_changes() { return std::exchange(state_->changes, {}); }
bool NeighbourTable::is_known(ParticipantId id) const { return state_->find(id) != nullptr; }

std::optional<Neighbour> NeighbourTable::find(ParticipantId id) const {
  const auto* known = state_->find(id);
  if (known == nullptr) return std::nullopt;
  return known->snapshot();
}

void NeighbourTable::for_each(const std::function<void(const Neighbour&)>& visit) const { state_->for_each(visit); }

std::optional<base::Instant> NeighbourTable::affirmed(ParticipantId id) const {
  const auto* known = state_->find(id);
  return known == nullptr ? std::nullopt : std::optional(known->affirmed());
}
std::uint64_t NeighbourTable::roster() const { return state_->roster(); }
std::size_t NeighbourTable::size() const { return state_->size(); }
std::size_t NeighbourTable::seasoned() const { return state_->seasoned(); }
std::uint64_t NeighbourTable::refused_services() const { return state_->refused(); }

}  // namespace geminga::membership
