// The part of the table that is about relays: testimony that it takes in from them, and ways that it tells one.
#include "discovery/membership/neighbour_table.hpp"

namespace geminga::membership {
namespace {

constexpr double lost_unit = 16;  // the loss is said in sixteenths

/// The loss of two hops, one behind the other.
double chained(double one, double other) { return 1 - (1 - one) * (1 - other); }

}  // namespace

void NeighbourTable::hear_behind(const announcement::Announcement& presence, const Passage& passage,
                                 base::Instant now) {
  for (const auto& said : presence.behind) {
    if (said.participant == self_ || said.participant == presence.participant) continue;
    const auto known = records_.find(said.participant);
    if (known == records_.end()) {
      lacks_and_doubts_.hear_stranger(said.participant, now);
      continue;
    }
    auto& record = *known->second.record;
    record.hear_of({.through = {presence.participant},
                    .hops = said.hops,
                    .interface = passage.interface,
                    .age = said.age,
                    .loss = chained(said.lost / lost_unit, passage.loss),
                    .interval = passage.interval,
                    .delay = passage.delay},
                   said.revision, now);
    admission_.update(*known->second.member, record.standing());
    update(*known, now);
  }
}

void NeighbourTable::suspect(ParticipantId id, base::Instant now) {
  const auto known = records_.find(id);
  if (known == records_.end()) return;
  known->second.record->suspect();
  update(*known, now);
}

void NeighbourTable::doubt(ParticipantId id, base::Instant now) {
  const auto known = records_.find(id);
  if (known == records_.end()) return;
  known->second.record->doubt();
  update(*known, now);
}

void NeighbourTable::judge_reach() {
  if (!judge_) return;
  for (auto& [id, known] : records_) known.record->judge_reach(judge_, changes_);
}

}  // namespace geminga::membership
