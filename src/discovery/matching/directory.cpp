#include "discovery/matching/directory.hpp"

#include "discovery/matching/conversions/converter.hpp"
#include "discovery/matching/degrees/representation.hpp"

namespace geminga::matching {

using registry::PublicationEntry;
using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

Directory::Directory(const Editions& editions, const Preparation& preparation)
    : editions_(editions), preparation_(preparation) {
  open_indexes(editions.in_force());
}

const StoredPublication& Directory::add(PublicationEntry entry) {
  const StoredPublication& stored = publications_.insert(std::move(entry), {});
  if (stored.slot >= of_publication_.size()) of_publication_.resize(stored.slot + 1);
  known(stored) = {};
  known(stored).arrival = ++arrivals_;
  take_in(stored);
  return stored;
}

std::shared_ptr<const PublicationEntry> Directory::replace(const StoredPublication& stored, PublicationEntry entry) {
  auto before = publications_.replace(stored, std::move(entry), {});
  take_in(stored);
  return before;
}

void Directory::take_in(const StoredPublication& stored) {
  const Publication& offered = stored.entry.publication;
  known(stored).audience =
      Audience::is_stated(offered) ? std::make_unique<const Audience>(Audience::parse(offered)) : nullptr;
  file(stored, editions_.in_force());
  if (editions_.are_both_filed()) file(stored, editions_.other());
}

const StoredSubscription& Directory::add(SubscriptionEntry entry, Request request) {
  const FilingPlan plan = this->plan(entry, request);
  const StoredSubscription& stored = subscriptions_.insert(std::move(entry), plan.filing());
  if (stored.slot >= of_subscription_.size()) of_subscription_.resize(stored.slot + 1);
  known(stored) = {
      .stored = &stored, .request = kept(std::move(request)), .generation = editions_.in_force().generation};
  if (!stored.entry.subscription.on.empty()) asking_on_.insert(stored.entry.key);
  watch(stored);
  return stored;
}

ReplacedSubscription Directory::replace(const StoredSubscription& stored, SubscriptionEntry entry, Request request) {
  const FilingPlan plan = this->plan(entry, request);
  unwatch(stored);
  KnownSubscription& subscription = known(stored);
  ReplacedSubscription before{subscriptions_.replace(stored, std::move(entry), plan.filing()),
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

std::shared_ptr<const Request> Directory::kept(Request request) const {
  return request.is_plain() ? plain_ : std::make_shared<const Request>(std::move(request));
}

void Directory::retire(const std::vector<const StoredPublication*>& publications, Reason reason) {
  std::vector<ServiceKey> keys;
  for (const auto* one : publications) {
    known(*one).leaves = reason;
    keys.push_back(one->entry.key);
  }
  for (const Edition* edition : {&editions_.in_force(), &editions_.other()}) {
    if (edition->converters == nullptr || edition->converters->is_empty()) continue;
    edition->converters->erase(keys);
    filed_ += edition->converters->take_work();
  }
}

void Directory::erase(const StoredPublication& stored) {
  filed_ += 1 + stored.classes[std::to_underlying(editions_.in_force().generation)].size();
  publications_.erase(stored);
}

void Directory::erase(const StoredSubscription& stored) {
  unwatch(stored);
  asking_on_.erase(stored.entry.key);
  known(stored) = {};
  subscriptions_.erase(stored);
}

void Directory::open_indexes(const Edition& edition) {
  publications_.set_class_count(index_size(edition), edition.generation);
  subscriptions_.set_class_count(index_size(edition), edition.generation);
}

void Directory::close_indexes(const Edition& edition) {
  publications_.set_class_count(0, edition.generation);
  subscriptions_.set_class_count(0, edition.generation);
}

void Directory::file(const StoredPublication& stored, const Edition& edition) {
  KnownPublication& publication = known(stored);
  const auto generation = std::to_underlying(edition.generation);
  publication.classes[generation] = preparation_.classes(stored.entry, edition.vocabulary);
  const Attributes& attributes = stored.entry.publication.attributes;
  publication.signatures[generation] =
      has_signature(attributes) ? std::make_unique<const Signature>(signature_of(attributes, edition.vocabulary))
                                : nullptr;
  if (!publication.leaves && (is_converter(attributes) || !edition.converters->is_empty())) {
    edition.converters->put(stored.entry, audience(publication), publication.arrival);
    filed_ += edition.converters->take_work();
  }
  const FilingPlan plan = FilingPlan::of_publication(publication.classes[generation], edition);
  publications_.refile(stored, plan.filing());
  filed_ += 1 + plan.size();
}

void Directory::unfile(const StoredPublication& stored, const Edition& edition) {
  const auto generation = std::to_underlying(edition.generation);
  filed_ += 1 + stored.classes[generation].size();
  publications_.unfile(stored, edition.generation);
  known(stored).classes[generation] = {};
  known(stored).signatures[generation] = nullptr;
}

void Directory::unfile(const StoredSubscription& stored) {
  unwatch(stored);
  subscriptions_.unfile(stored, std::exchange(known(stored).generation, editions_.in_force().generation));
}

Request Directory::file(const StoredSubscription& stored, Request request) {
  const FilingPlan plan = this->plan(stored.entry, request);
  subscriptions_.refile(stored, plan.filing());
  filed_ += 1 + plan.size();
  Request before = *std::exchange(known(stored).request, kept(std::move(request)));
  watch(stored);
  return before;
}

void Directory::watch(const StoredSubscription& stored) {
  const Request& request = this->request(stored);
  if (request.consumer == nullptr) return;
  edition_of(stored).converters->watch(request.consumer, *request.classes.representation_class);
}

void Directory::unwatch(const StoredSubscription& stored) { edition_of(stored).converters->unwatch(stored.entry.key); }

std::shared_ptr<const vocabulary::Chain> Directory::chain(const StoredSubscription& subscription,
                                                          const StoredPublication& publication) const {
  const Edition& edition = edition_of(subscription);
  const Request& asked = request(subscription);
  return chain_between(classes(publication, edition).representation_class, asked.classes.representation_class,
                       edition.vocabulary, asked.asks.chains);
}

std::vector<const StoredSubscription*> Directory::subscriptions_found_for(const StoredPublication& publication) const {
  std::vector<const StoredSubscription*> found;
  const auto add = [&](const Edition& edition) {
    add_subscriptions_for(subscriptions_, publication, classes(publication, edition), edition, found);
  };
  add(editions_.in_force());
  if (editions_.stage() == ChangeStage::rematching) add(editions_.other());
  return found;
}

std::vector<const StoredSubscription*> Directory::subscriptions_for(const StoredPublication& publication) const {
  auto found = subscriptions_found_for(publication);
  order_by_key(found);
  return found;
}

}  // namespace geminga::matching
