// A queue of the changes of neighbours that the matcher has not taken in yet.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_NEIGHBOUR_QUEUE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_NEIGHBOUR_QUEUE_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "discovery/membership/neighbour/change.hpp"

namespace geminga::participant {

/// Changes come out in the order in which they came in, with two exceptions. The last change of a service takes the
/// position of an earlier one that waits. A participant's departure replaces all that waits of it. So the queue holds
/// at most one change for each service that the table or the matcher knows.
class NeighbourQueue {
 public:
  void push(membership::Change change);
  [[nodiscard]] bool is_empty() const { return changes_.empty(); }
  /// The oldest; there must be one.
  [[nodiscard]] membership::Change pop();

 private:
  /// One number may be that of a publication that goes and of a subscription that comes.
  enum class Side : std::uint8_t { publication, subscription };
  using Service = std::pair<ServiceKey, Side>;

  /// Nothing for a change that is about a whole participant.
  [[nodiscard]] static std::optional<Service> service_of(const membership::Change& change);
  void drop_all_of(ParticipantId participant);

  std::map<std::uint64_t, membership::Change> changes_;  ///< by the order of arrival
  std::map<Service, std::uint64_t> of_service_;          ///< the position of its change
  std::uint64_t next_ = 0;
};

}  // namespace geminga::participant

#endif
