#include "discovery/matching/departures.hpp"

#include <algorithm>
#include <utility>

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

namespace {

/// Of the subscriptions that consider a publication the one with the least key, so that the order of what is told does
/// not depend on slots, and so on what has gone before; of very many any one. There is one at least.
const StoredSubscription& first_of(const ConsideredBy& considered_by, const Directory& directory) {
  const StoredSubscription* first = &directory.requests().at(considered_by.begin()->first);
  if (considered_by.size() > max_passed_in_step) return *first;
  for (const auto& [slot, rank] : considered_by) {
    const StoredSubscription& one = directory.requests().at(slot);
    if (one.entry.key < first->entry.key) first = &one;
  }
  return *first;
}

}  // namespace

void Departures::remove(const std::vector<const StoredPublication*>& publications,
                        const std::vector<const StoredSubscription*>& subscriptions, Reason reason) {
  const bool was_idle = agenda_.is_empty();
  Cause cause;
  directory_.offers().retire(publications, reason);
  for (const auto* subscription : subscriptions) directory_.requests().retire(*subscription);
  for (const auto* subscription : subscriptions) pairs_.end(*subscription, reason, cause);
  for (const auto* subscription : pairs_.withdraw(publications, reason)) pairs_.settle(*subscription, cause);
  std::set<Id32> numbers;
  for (const auto* publication : publications) erase(directory_.offers(), *publication, numbers);
  for (const auto* subscription : subscriptions) erase(directory_.requests(), *subscription, numbers);
  while (!numbers.empty()) review(numbers);
  agenda_.relieve();
  if (was_idle) agenda_.take_some();
}

void Departures::review(std::set<Id32>& numbers) {
  for (std::size_t count = 0; count < max_reviewed_in_step && !numbers.empty(); ++count) {
    agenda_.judge_anew(clashes_.review(*numbers.begin(), Clashes::Change::went));
    numbers.erase(numbers.begin());
    ++passed_;
  }
}

void Departures::begin(ParticipantId participant, Reason reason) {
  begin(directory_.offers().table().of_participant(participant),
        directory_.requests().table().of_participant(participant), reason);
}

void Departures::begin(std::vector<const StoredPublication*> publications,
                       std::vector<const StoredSubscription*> subscriptions, Reason reason) {
  std::erase_if(publications, [&](const auto* one) { return directory_.offers().is_going(*one); });
  std::erase_if(subscriptions, [&](const auto* one) { return directory_.requests().is_going(*one); });
  directory_.offers().retire(publications, reason);
  for (const auto* subscription : subscriptions) directory_.requests().retire(*subscription);
  // Taken from the back, in ascending order of key.
  std::ranges::reverse(subscriptions);
  std::ranges::reverse(publications);
  departures_.push_back({std::move(publications), std::move(subscriptions), reason, {}});
}

bool Departures::next() {
  if (departures_.empty()) return false;
  Departure& departure = departures_.front();
  if (!departure.subscriptions.empty()) {
    const StoredSubscription& subscription = *departure.subscriptions.back();
    departure.subscriptions.pop_back();
    Cause cause;
    pairs_.end(subscription, departure.reason, cause);
    erase(directory_.requests(), subscription, departure.numbers);
  } else if (!departure.publications.empty()) {
    if (end_one_consumer(departure, *departure.publications.back())) return true;
    erase(directory_.offers(), *departure.publications.back(), departure.numbers);
    departure.publications.pop_back();
  } else if (!departure.numbers.empty()) {
    review(departure.numbers);
  } else {
    departures_.pop_front();
    agenda_.relieve();
  }
  return true;
}

bool Departures::end_one_consumer(const Departure& departure, const StoredPublication& publication) {
  const ConsideredBy& considered_by = pairs_.considered_by(publication);
  if (considered_by.empty()) return false;
  // One subscription loses all of them at once, so that nothing that is about to go takes another's place.
  const StoredSubscription& subscription = first_of(considered_by, directory_);
  Cause cause;
  for (const auto* one : departure.publications) {
    if (pairs_.considered_by(*one).contains(subscription.slot)) pairs_.judge(subscription, *one, cause);
  }
  passed_ += departure.publications.size();
  pairs_.settle(subscription, cause);
  return true;
}

}  // namespace geminga::matching
