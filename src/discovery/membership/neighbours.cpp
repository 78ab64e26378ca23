#include "discovery/membership/neighbours.hpp"

namespace geminga::membership {

std::optional<Neighbour> Neighbours::find(ParticipantId id) const {
  const auto* known = records_.record(id);
  if (known == nullptr) return std::nullopt;
  return known->snapshot();
}

void Neighbours::for_each(const std::function<void(const Neighbour&)>& visit) const {
  for (const auto& [id, known] : records_) visit(known.record->snapshot());
}

std::optional<base::Instant> Neighbours::affirmed(ParticipantId id) const {
  const auto* known = records_.record(id);
  return known == nullptr ? std::nullopt : std::optional(known->affirmed());
}

std::optional<Reach> Neighbours::reach(ParticipantId id) const {
  const auto* known = records_.record(id);
  return known == nullptr ? std::nullopt : std::optional(known->reach());
}

void Neighbours::for_each_reach(const std::function<void(const Reach&)>& visit) const {
  for (const auto& [id, known] : records_) visit(known.record->reach());
}

bool Neighbours::is_heard_directly(ParticipantId id, base::Instant now) const {
  const auto* known = records_.record(id);
  return known != nullptr && known->is_heard_directly(now);
}

}  // namespace geminga::membership
