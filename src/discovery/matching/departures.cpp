#include "discovery/matching/departures.hpp"

#include <algorithm>
#include <utility>

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

void Departures::remove(const std::vector<const StoredPublication*>& publications,
                        const std::vector<const StoredSubscription*>& subscriptions, Reason reason) {
  Cause cause;
  for (const auto* publication : publications) directory_.retire(*publication, reason);
  for (const auto* subscription : subscriptions) directory_.retire(*subscription);
  for (const auto* subscription : subscriptions) pairs_.end(*subscription, reason, cause);
  for (const auto* subscription : pairs_.withdraw(publications, reason)) pairs_.settle(*subscription, cause);
  std::set<Id32> numbers;
  for (const auto* publication : publications) erase(*publication, numbers);
  for (const auto* subscription : subscriptions) erase(*subscription, numbers);
  review(numbers);
  stale_.judge_some();
}

void Departures::review(const std::set<Id32>& numbers) {
  Cause cause;
  for (const Id32 number : numbers) pairs_.judge_anew(clashes_.review(number, false), cause);
  pairs_.relieve(cause);
}

void Departures::begin(ParticipantId participant, Reason reason) {
  Departure departure{directory_.publications().of_participant(participant),
                      directory_.subscriptions().of_participant(participant),
                      reason,
                      {}};
  std::erase_if(departure.publications, [&](const auto* one) { return directory_.is_going(*one); });
  std::erase_if(departure.subscriptions, [&](const auto* one) { return directory_.is_going(*one); });
  for (const auto* publication : departure.publications) directory_.retire(*publication, reason);
  for (const auto* subscription : departure.subscriptions) directory_.retire(*subscription);
  // Taken from the back, in ascending order of key.
  std::ranges::reverse(departure.subscriptions);
  std::ranges::reverse(departure.publications);
  departures_.push_back(std::move(departure));
}

bool Departures::next() {
  if (departures_.empty()) return false;
  Departure& departure = departures_.front();
  if (!departure.subscriptions.empty()) {
    const StoredSubscription& subscription = *departure.subscriptions.back();
    departure.subscriptions.pop_back();
    Cause cause;
    pairs_.end(subscription, departure.reason, cause);
    erase(subscription, departure.numbers);
  } else if (departure.publications.empty()) {
    const std::set<Id32> numbers = std::move(departure.numbers);
    departures_.pop_front();
    review(numbers);
  } else if (!end_one_consumer(departure, *departure.publications.back())) {
    erase(*departure.publications.back(), departure.numbers);
    departure.publications.pop_back();
  }
  return true;
}

bool Departures::end_one_consumer(const Departure& departure, const StoredPublication& publication) {
  const ConsideredBy& considered_by = pairs_.considered_by(publication);
  if (considered_by.empty()) return false;
  // One subscription loses all of them at once, so that nothing that is about to go takes another's place.
  const StoredSubscription& subscription = directory_.subscription_at(considered_by.begin()->first);
  Cause cause;
  for (const auto* one : departure.publications) {
    if (pairs_.considered_by(*one).contains(subscription.slot)) pairs_.judge(subscription, *one, cause);
  }
  passed_ += departure.publications.size();
  pairs_.settle(subscription, cause);
  return true;
}

}  // namespace geminga::matching
