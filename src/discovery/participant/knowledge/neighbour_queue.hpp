// A queue of the changes of neighbours that the matcher has not taken in yet.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_NEIGHBOUR_QUEUE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_NEIGHBOUR_QUEUE_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/time.hpp"
#include "discovery/membership/neighbour/change.hpp"
#include "discovery/participant/knowledge/converter_budget.hpp"

namespace geminga::participant {

/// Changes come out in the order in which they came in, with three exceptions. The last change of a service takes the
/// position of an earlier one that waits. A participant's departure replaces all that waits of it. A change to a
/// converter beyond the budget of its participant waits until there is budget. So the queue holds at most one change
/// for each service that the table or the matcher knows.
class NeighbourQueue {
 public:
  void push(membership::Change change);
  /// Whether pop() gives a change at `now`.
  [[nodiscard]] bool has_due(base::Instant now) const { return !changes_.empty() || next_due() <= now; }
  /// When the next change to a converter has budget again; base::never: none waits for that.
  [[nodiscard]] base::Instant next_due() const { return dues_.empty() ? base::never : dues_.begin()->first; }
  /// The next change; nothing where all that are left wait for budget. O(log n) for each change that begins to wait.
  [[nodiscard]] std::optional<membership::Change> pop(base::Instant now);
  /// How many changes to converters wait for budget.
  [[nodiscard]] std::size_t held() const { return held_.size(); }

 private:
  /// One number may be that of a publication that goes and of a subscription that comes.
  enum class Side : std::uint8_t { publication, subscription };
  using Service = std::pair<ServiceKey, Side>;
  /// Changes of one participant that wait for budget, by position.
  struct Waiting {
    std::set<std::uint64_t> positions;
    base::Instant due{};
  };

  /// Nothing for a change that is about a whole participant.
  [[nodiscard]] static std::optional<Service> service_of(const membership::Change& change);
  void drop_all_of(ParticipantId participant);
  void hold(std::uint64_t position, membership::Change change, ParticipantId participant);
  void release(std::uint64_t position, ParticipantId participant);
  /// The next change whose wait is over; nothing where others have used the budget of all meanwhile.
  [[nodiscard]] std::optional<membership::Change> pop_held(base::Instant now);

  std::map<std::uint64_t, membership::Change> changes_;  ///< by the order of arrival
  std::map<std::uint64_t, membership::Change> held_;     ///< the same, of those that wait for budget
  std::map<Service, std::uint64_t> of_service_;          ///< the position of its change
  std::map<ParticipantId, Waiting> waiting_;
  std::set<std::pair<base::Instant, ParticipantId>> dues_;  ///< when a participant that has changes in held_ has budget
  ConverterBudget budget_;
  std::uint64_t next_ = 0;
};

}  // namespace geminga::participant

#endif
