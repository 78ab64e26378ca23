#include "discovery/participant/knowledge/neighbour_queue.hpp"

#include <type_traits>
#include <variant>

#include "discovery/matching/conversions/converter.hpp"

namespace geminga::participant {
namespace {

/// Whether a change brings a converter, or another one in its place.
bool changes_converter(const membership::Change& change) {
  const auto* put = std::get_if<membership::PutPublication>(&change);
  return put != nullptr && matching::is_converter(put->publication.attributes);
}

}  // namespace

std::optional<NeighbourQueue::Service> NeighbourQueue::service_of(const membership::Change& change) {
  return std::visit(
      [](const auto& one) -> std::optional<Service> {
        using One = std::remove_cvref_t<decltype(one)>;
        if constexpr (std::is_same_v<One, membership::RemoveParticipant>) {
          return std::nullopt;
        } else {
          constexpr bool is_publication =
              std::is_same_v<One, membership::PutPublication> || std::is_same_v<One, membership::RemovePublication>;
          return Service{one.key, is_publication ? Side::publication : Side::subscription};
        }
      },
      change);
}

void NeighbourQueue::push(membership::Change change) {
  const auto service = service_of(change);
  if (!service) {
    drop_all_of(std::get<membership::RemoveParticipant>(change).participant);
  } else if (const auto [known, is_new] = of_service_.emplace(*service, next_); !is_new) {
    if (const auto held = held_.find(known->second); held != held_.end() && changes_converter(change)) {
      held->second = std::move(change);
      return;
    }
    release(known->second, service->first.participant);
    changes_.insert_or_assign(known->second, std::move(change));
    return;
  }
  changes_.emplace(next_++, std::move(change));
}

void NeighbourQueue::drop_all_of(ParticipantId participant) {
  auto at =
      of_service_.lower_bound({ServiceKey{.participant = participant, .peer = {}, .number = 0}, Side::publication});
  while (at != of_service_.end() && at->first.first.participant == participant) {
    changes_.erase(at->second);
    release(at->second, participant);
    at = of_service_.erase(at);
  }
}

void NeighbourQueue::hold(std::uint64_t position, membership::Change change, ParticipantId participant) {
  held_.emplace(position, std::move(change));
  const auto [waiting, is_new] = waiting_.try_emplace(participant);
  waiting->second.positions.insert(position);
  if (!is_new) return;
  waiting->second.due = budget_.next(participant);
  dues_.emplace(waiting->second.due, participant);
}

void NeighbourQueue::release(std::uint64_t position, ParticipantId participant) {
  if (held_.erase(position) == 0) return;
  const auto waiting = waiting_.find(participant);
  waiting->second.positions.erase(position);
  if (!waiting->second.positions.empty()) return;
  dues_.erase({waiting->second.due, participant});
  waiting_.erase(waiting);
}

std::optional<membership::Change> NeighbourQueue::pop_held(base::Instant now) {
  const ParticipantId participant = dues_.begin()->second;
  const auto waiting = waiting_.find(participant);
  const bool has_budget = budget_.next(participant) <= now;
  if (has_budget) budget_.take(participant, now);
  dues_.erase(dues_.begin());
  waiting->second.due = budget_.next(participant);
  dues_.emplace(waiting->second.due, participant);
  if (!has_budget) return std::nullopt;
  const std::uint64_t position = *waiting->second.positions.begin();
  membership::Change change = std::move(held_.at(position));
  release(position, participant);
  return change;
}

std::optional<membership::Change> NeighbourQueue::pop(base::Instant now) {
  std::optional<membership::Change> change;
  if (next_due() <= now) {
    change = pop_held(now);
  } else if (!changes_.empty()) {
    const auto first = changes_.begin();
    const std::uint64_t position = first->first;
    change = std::move(first->second);
    changes_.erase(first);
    if (changes_converter(*change)) {
      const ParticipantId participant = std::get<membership::PutPublication>(*change).key.participant;
      if (budget_.next(participant) > now || waiting_.contains(participant)) {
        hold(position, std::move(*change), participant);
        return std::nullopt;
      }
      budget_.take(participant, now);
    }
  }
  if (!change) return std::nullopt;
  if (const auto service = service_of(*change)) of_service_.erase(*service);
  return change;
}

}  // namespace geminga::participant
