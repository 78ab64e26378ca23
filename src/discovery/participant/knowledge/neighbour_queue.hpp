// What the table of neighbours has found changed and the matcher has not been told yet.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_NEIGHBOUR_QUEUE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_NEIGHBOUR_QUEUE_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "discovery/membership/neighbour/change.hpp"

namespace geminga::participant {

/// In the order in which they came, but that only the last change of a service counts and takes the place of an earlier
/// one that waits, and that a participant's departure takes the place of all that waits of it. So it holds at most one
/// change for each service that the table or the matcher knows.
class NeighbourQueue {
 public:
  void push(membership::Change change);
  [[nodiscard]] bool is_empty() const { return changes_.empty(); }
  /// The eldest; there must be one.
  [[nodiscard]] membership::Change pop();

 private:
  /// A number may be that of a publication that goes and of a subscription that comes.
  enum class Kind : std::uint8_t { publication, subscription };
  using Service = std::pair<ServiceKey, Kind>;

  /// Nothing for what is about a whole participant.
  [[nodiscard]] static std::optional<Service> service_of(const membership::Change& change);
  void drop_all_of(ParticipantId participant);

  std::map<std::uint64_t, membership::Change> changes_;  ///< by the order of their coming
  std::map<Service, std::uint64_t> of_service_;          ///< which of them is its
  std::uint64_t next_ = 0;
};

}  // namespace geminga::participant

#endif
