#include "discovery/matching/requests.hpp"

#include <utility>

namespace geminga::matching {

using registry::StoredSubscription;
using registry::SubscriptionEntry;

const StoredSubscription& Requests::add(SubscriptionEntry entry, Request request) {
  const FilingPlan plan = this->plan(entry, request);
  const StoredSubscription& stored = table_.insert(std::move(entry), plan.filing());
  if (stored.slot >= known_.size()) known_.resize(stored.slot + 1);
  known(stored) = {
      .stored = &stored, .request = kept(std::move(request)), .generation = editions_.in_force().generation};
  if (!stored.entry.subscription.on.empty()) asking_on_.insert(stored.entry.key);
  watch(stored);
  return stored;
}

ReplacedSubscription Requests::replace(const StoredSubscription& stored, SubscriptionEntry entry, Request request) {
  const FilingPlan plan = this->plan(entry, request);
  unwatch(stored);
  Known& subscription = known(stored);
  ReplacedSubscription before{table_.replace(stored, std::move(entry), plan.filing()),
                              *std::exchange(subscription.request, kept(std::move(request))),
                              std::exchange(subscription.generation, editions_.in_force().generation)};
  if (stored.entry.subscription.on.empty()) {
    asking_on_.erase(stored.entry.key);
  } else {
    asking_on_.insert(stored.entry.key);
  }
  watch(stored);
  return before;
}

std::shared_ptr<const Request> Requests::kept(Request request) const {
  return request.is_plain() ? plain_ : std::make_shared<const Request>(std::move(request));
}

void Requests::erase(const StoredSubscription& stored) {
  unwatch(stored);
  asking_on_.erase(stored.entry.key);
  known(stored) = {};
  table_.erase(stored);
}

void Requests::unfile(const StoredSubscription& stored) {
  unwatch(stored);
  table_.unfile(stored, std::exchange(known(stored).generation, editions_.in_force().generation));
}

Request Requests::file(const StoredSubscription& stored, Request request) {
  const FilingPlan plan = this->plan(stored.entry, request);
  table_.refile(stored, plan.filing());
  filed_ += 1 + plan.size();
  Request before = *std::exchange(known(stored).request, kept(std::move(request)));
  watch(stored);
  return before;
}

void Requests::watch(const StoredSubscription& stored) {
  const Request& request = this->request(stored);
  if (request.consumer == nullptr) return;
  edition_of(stored).converters->watch(request.consumer, *request.classes.representation_class);
}

void Requests::unwatch(const StoredSubscription& stored) { edition_of(stored).converters->unwatch(stored.entry.key); }

}  // namespace geminga::matching
