// Removes everything of a participant, in steps that are each about one subscription or one publication.
#include <algorithm>
#include <utility>

#include "discovery/matching/state.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

void Matcher::State::begin_departure(ParticipantId participant, Reason reason) {
  Departure departure{
      publications_.of_participant(participant), subscriptions_.of_participant(participant), reason, {}};
  std::erase_if(departure.publications, [&](const auto* one) { return of(*one).leaves.has_value(); });
  std::erase_if(departure.subscriptions, [&](const auto* one) { return of(*one).is_leaving; });
  for (const auto* publication : departure.publications) retire(*publication, reason);
  for (const auto* subscription : departure.subscriptions) of(*subscription).is_leaving = true;
  // Taken from the back, in ascending order of key.
  std::ranges::reverse(departure.subscriptions);
  std::ranges::reverse(departure.publications);
  departures_.push_back(std::move(departure));
}

bool Matcher::State::depart_next() {
  if (departures_.empty()) return false;
  begin_cause();
  Departure& departure = departures_.front();
  if (!departure.subscriptions.empty()) {
    const StoredSubscription& subscription = *departure.subscriptions.back();
    departure.subscriptions.pop_back();
    forget(subscription, departure.reason);
    erase(subscription, departure.numbers);
    begin_cause();
    return true;
  }
  if (departure.publications.empty()) {
    const std::set<Id32> numbers = std::move(departure.numbers);
    departures_.pop_front();
    for (const Id32 number : numbers) judge_anew(review(number, false));
    relieve();
    return true;
  }
  const StoredPublication& publication = *departure.publications.back();
  const auto& considered_by = of(publication).considered_by;
  if (considered_by.empty()) {
    departure.publications.pop_back();
    erase(publication, departure.numbers);
    begin_cause();
    return true;
  }
  // One subscription loses all of them at once, so that nothing that is about to go takes another's place.
  const StoredSubscription& subscription = *of_subscription_[considered_by.begin()->first].stored;
  for (const auto* one : departure.publications) {
    if (of(*one).considered_by.contains(subscription.slot)) judge(subscription, *one);
  }
  filed_ += departure.publications.size();
  settle(subscription);
  return true;
}

}  // namespace geminga::matching
