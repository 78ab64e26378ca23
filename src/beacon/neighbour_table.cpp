// Which datagrams count, and for whom; what they say is taken in by the participant's record.
#include "beacon/neighbour_table.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <utility>

#include "beacon/limits.hpp"
#include "beacon/neighbour_record.hpp"

namespace geminga::beacon {
namespace {

using base::Instant;

constexpr std::array<std::string_view, 9> words = {"own",     "clash",       "claim", "newcomer", "known",
                                                   "goodbye", "other-group", "stale", "full"};

/// A life that has said goodbye; its late datagrams bring nobody back.
struct Departed {
  ParticipantId id{};
  BootNonce boot{};
  Instant until;
};

}  // namespace

std::string_view to_string(Hearing hearing) { return words[std::to_underlying(hearing)]; }

// Adapting the deadline to the measured loss is a matter of this function alone; `loss` is there for it.
Instant deadline_of(Instant heard, base::Duration interval, [[maybe_unused]] double loss) {
  return heard + deadline_intervals * interval;
}

class NeighbourTable::State {
 public:
  explicit State(std::string group) : group_(std::move(group)) {}

  Hearing hear(const Announcement& announcement, const Arrival& arrival) {
    if (announcement.group != group_) return Hearing::other_group;
    if (announcement.boot == self_boot_) return Hearing::own;
    if (announcement.participant == self_) return Hearing::clash;
    if (has_departed(announcement, arrival.now)) return Hearing::stale;
    switch (announcement.kind) {
      case Kind::claim:
        return Hearing::claim;
      case Kind::goodbye:
        return hear_goodbye(announcement, arrival.now);
      case Kind::state:
        break;
    }
    return hear_state(announcement, arrival);
  }

  void expire(Instant now) {
    for (auto position = records.begin(); position != records.end();) {
      if (position->second.deadline() > now) {
        if (position->second.next_deadline() <= now) position->second.expire(now, changes);
        ++position;
      } else {
        changes.emplace_back(RemoveParticipant{position->first, Departure::expired});
        position = records.erase(position);
      }
    }
  }

  void set_self(ParticipantId id, BootNonce boot) {
    self_ = id;
    self_boot_ = boot;
  }

  ServiceRoom room;  // before the records, which give back to it at their end
  std::map<ParticipantId, NeighbourRecord> records;
  std::vector<Change> changes;

 private:
  bool has_departed(const Announcement& announcement, Instant now) {
    while (!departed_.empty() && departed_.front().until <= now) departed_.pop_front();
    return std::ranges::any_of(departed_, [&](const Departed& each) {
      return each.id == announcement.participant && each.boot == announcement.boot;
    });
  }

  Hearing hear_goodbye(const Announcement& announcement, Instant now) {
    const auto known = records.find(announcement.participant);
    if (known == records.end() || known->second.boot() != announcement.boot) return Hearing::stale;
    if (departed_.size() == max_participants) departed_.pop_front();
    departed_.push_back({announcement.participant, announcement.boot, now + goodbye_memory});
    changes.emplace_back(RemoveParticipant{announcement.participant, Departure::left});
    records.erase(known);
    return Hearing::goodbye;
  }

  Hearing hear_state(const Announcement& announcement, const Arrival& arrival) {
    auto hearing = Hearing::known;
    auto known = records.find(announcement.participant);
    if (known == records.end()) {
      if (records.size() == max_participants) return Hearing::full;
      known = records.try_emplace(announcement.participant, announcement, room).first;
      hearing = Hearing::newcomer;
    } else if (known->second.boot() != announcement.boot) {
      if (known->second.is_retired(announcement.boot)) return Hearing::stale;
      known->second.restart(announcement.boot);
      hearing = Hearing::newcomer;
    }
    known->second.hear(announcement, arrival, changes);
    return hearing;
  }

  std::string group_;
  ParticipantId self_{};
  BootNonce self_boot_{};
  std::deque<Departed> departed_;  // in the order of `until`
};

NeighbourTable::NeighbourTable(std::string group) : state_(std::make_unique<State>(std::move(group))) {}
NeighbourTable::~NeighbourTable() = default;

void NeighbourTable::set_self(ParticipantId id, BootNonce boot) { state_->set_self(id, boot); }

Hearing NeighbourTable::hear(const Announcement& announcement, const Arrival& arrival) {
  return state_->hear(announcement, arrival);
}

void NeighbourTable::expire(base::Instant now) { state_->expire(now); }

base::Instant NeighbourTable::next_deadline() const {
  auto next = base::never;
  for (const auto& [id, record] : state_->records) next = std::min(next, record.next_deadline());
  return next;
}

void NeighbourTable::forget_interface(env::InterfaceIndex interface) {
  for (auto& [id, record] : state_->records) record.forget_interface(interface, state_->changes);
}

std::vector<Change> NeighbourTable::take_changes() { return std::exchange(state_->changes, {}); }

bool NeighbourTable::is_known(ParticipantId id) const { return state_->records.contains(id); }

std::optional<Neighbour> NeighbourTable::find(ParticipantId id) const {
  const auto known = state_->records.find(id);
  if (known == state_->records.end()) return std::nullopt;
  return known->second.snapshot();
}

void NeighbourTable::for_each(const std::function<void(const Neighbour&)>& visit) const {
  for (const auto& [id, record] : state_->records) visit(record.snapshot());
}

std::size_t NeighbourTable::size() const { return state_->records.size(); }

std::uint64_t NeighbourTable::refused_services() const { return state_->room.refused; }

}  // namespace geminga::beacon
