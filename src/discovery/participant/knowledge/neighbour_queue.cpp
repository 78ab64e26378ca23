#include "discovery/participant/knowledge/neighbour_queue.hpp"

#include <type_traits>
#include <variant>

#include "base/assert.hpp"

namespace geminga::participant {

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
    at = of_service_.erase(at);
  }
}

membership::Change NeighbourQueue::pop() {
  GEMINGA_ASSERT(!changes_.empty());
  membership::Change change = std::move(changes_.begin()->second);
  changes_.erase(changes_.begin());
  if (const auto service = service_of(change)) of_service_.erase(*service);
  return change;
}

}  // namespace geminga::participant
