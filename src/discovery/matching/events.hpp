// The events of local peers: what is told of the choice of a subscription, to whom, and in which order.
#ifndef GEMINGA_DISCOVERY_MATCHING_EVENTS_HPP
#define GEMINGA_DISCOVERY_MATCHING_EVENTS_HPP

#include <utility>
#include <vector>

#include "discovery/matching/arbitration/choice.hpp"
#include "discovery/matching/cause.hpp"
#include "discovery/matching/directory.hpp"
#include "discovery/matching/event.hpp"

namespace geminga::matching {

class Events {
 public:
  explicit Events(const Directory& directory) : directory_(directory) {}

  /// Tells both sides of each pair what a verdict on the subscription changed.
  void tell(const registry::StoredSubscription& subscription, const Verdict& verdict, const Cause& cause);
  /// Tells the providers that a subscription ends. Its consumer knows.
  void tell_end(const registry::StoredSubscription& subscription, const std::vector<Verdict::Come>& chosen,
                Reason reason, const Cause& cause);

  /// The events since the last call, in the order in which they must be written.
  [[nodiscard]] std::vector<Event> take() { return std::exchange(events_, {}); }

 private:
  void tell_consumer(Change change, const registry::StoredSubscription& subscription,
                     const registry::StoredPublication& publication, Match match, Reason reason, const Cause& cause);
  void tell_provider(Change change, const registry::StoredSubscription& subscription,
                     const registry::StoredPublication& publication, Match match, Reason reason, const Cause& cause);

  const Directory& directory_;
  std::vector<Event> events_;
};

}  // namespace geminga::matching

#endif
