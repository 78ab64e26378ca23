// The order of participants, which gives each two bits their meaning.
#include "discovery/membership/witnesses.hpp"

#include <array>
#include <optional>
#include <span>
#include <utility>

#include "base/hash.hpp"

namespace geminga::membership {
namespace {

using announcement::HeardWithin;
using base::Instant;

std::uint64_t fold_of(ParticipantId id, announcement::BootNonce boot) {
  const std::array<std::uint64_t, 2> numbers{std::to_underlying(id), std::to_underlying(boot)};
  return base::hash64(base::octets_of(std::span(numbers)));
}

/// Visits all records and, as nullptr, ourselves, by ascending identifier.
template <typename AllRecords, typename Visit>
void for_each_member(AllRecords& records, ParticipantId self, Visit visit) {
  bool is_self_due = true;
  for (auto& [id, known] : records) {
    if (is_self_due && self < id) {
      visit(static_cast<NeighbourRecord*>(nullptr));
      is_self_due = false;
    }
    visit(known.record.get());
  }
  if (is_self_due) visit(static_cast<NeighbourRecord*>(nullptr));
}

/// The earliest instant at which somebody was heard who was heard so lately.
std::optional<Instant> seen_at(HeardWithin within, base::Duration interval, Instant now) {
  switch (within) {
    case HeardWithin::longer:
      return std::nullopt;
    case HeardWithin::interval:
      return now - interval;
    case HeardWithin::half:
      return now - interval / 2;
    case HeardWithin::quarter:
      return now - interval / 4;
  }
  return std::nullopt;
}

}  // namespace

void Witnesses::set_self(ParticipantId id, announcement::BootNonce boot) {
  self_ = id;
  self_boot_ = boot;
}

void Witnesses::toggle(ParticipantId id, announcement::BootNonce boot) { others_ ^= fold_of(id, boot); }

std::uint16_t Witnesses::members() const { return static_cast<std::uint16_t>(others_ ^ fold_of(self_, self_boot_)); }

announcement::Witness Witnesses::say(const Records& records, Instant now) const {
  announcement::Witness witness{.members = members(), .heard = {}};
  for_each_member(records, self_, [&](const NeighbourRecord* record) {
    witness.heard.push_back(record == nullptr ? HeardWithin::longer : record->heard_within(now));
  });
  return witness;
}

bool Witnesses::hear(Records& records, const announcement::Announcement& presence, Instant now) const {
  const auto& heard = presence.witness.heard;
  const auto count = records.size() + 1;
  if (presence.witness.members != members() || (heard.size() + 3) / 4 != (count + 3) / 4) return false;
  std::size_t place = 0;
  for_each_member(records, self_, [&](NeighbourRecord* record) {
    const auto within = heard[place++];
    if (record == nullptr || record->services().owner().id == presence.participant) return;
    record->witness(seen_at(within, record->interval(), now), now);
  });
  return true;
}

}  // namespace geminga::membership
