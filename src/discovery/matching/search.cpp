#include "discovery/matching/search.hpp"

#include <algorithm>
#include <ranges>
#include <string_view>
#include <utility>

namespace geminga::matching {

using registry::PublicationEntry;
using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

namespace {

/// Adds the classes that are equivalent to this one, itself included.
void add_equivalents(const vocabulary::Vocabulary& vocabulary, vocabulary::ClassNumber number,
                     std::vector<vocabulary::ClassNumber>& classes) {
  for (const vocabulary::ClassNumber one : vocabulary.subsumers(number)) {
    if (vocabulary.is_subsumed(one, number)) classes.push_back(one);
  }
}

}  // namespace

std::optional<std::vector<ServiceKey>> Search::candidates(const Subscription& asked, const Request& request,
                                                          std::size_t most) const {
  auto keys = some_candidates(asked, request, most + 1);
  return keys.size() > most ? std::nullopt : std::optional(std::move(keys));
}

std::vector<ServiceKey> Search::some_candidates(const Subscription& asked, const Request& request,
                                                std::size_t most) const {
  std::vector<ServiceKey> keys;
  directory_.visit_publications_for(asked, request, [&](const StoredPublication& publication) {
    if (keys.size() < most) keys.push_back(publication.entry.key);
    return keys.size() >= most;
  });
  return keys;
}

bool Search::examine_requests(const std::optional<ServiceKey>& after, const PublicationEntry& offered,
                              const VisitFinding& visit) const {
  const Imagined imagined(offered, editions_.vocabulary(), preparation_.placing());
  return directory_.requests().table().visit_after(after, [&](const StoredSubscription& stored) {
    return directory_.requests().is_going(stored) || visit(stored.entry, examination_.examine(stored, imagined.offer));
  });
}

std::size_t Search::examine_near(const PublicationEntry& offered, std::size_t most, const VisitFinding& visit) const {
  const auto* publication = directory_.offers().table().find(offered.key);
  if (publication == nullptr) return 0;
  const Edition& edition = editions_.in_force();
  const Classes& known = directory_.offers().classes(*publication, edition);
  std::vector<const StoredSubscription*> found;
  add_subscriptions_for(directory_.requests().table(), *publication, known, edition, found);
  order_by_key(found);
  std::size_t searched = 0;
  if (known.concept_class && edition.vocabulary.is_satisfiable(*known.concept_class)) {
    searched = add_narrower(*known.concept_class, most, found);
  }
  if (found.size() > most) found.resize(most);
  const Offer offer = directory_.offers().offer(*publication, edition);
  for (const StoredSubscription* stored : found) {
    if (!directory_.requests().is_going(*stored) && !visit(stored->entry, examination_.examine(*stored, offer))) break;
  }
  return found.size() + searched;
}

std::size_t Search::add_narrower(vocabulary::ClassNumber concept_class, std::size_t most,
                                 std::vector<const StoredSubscription*>& found) const {
  const Edition& edition = editions_.in_force();
  const vocabulary::Vocabulary& vocabulary = edition.vocabulary;
  std::vector<vocabulary::ClassNumber> walked{concept_class};
  for (std::size_t i = 0; i < walked.size() && found.size() < most; ++i) {
    std::vector<vocabulary::ClassNumber> equal;
    if (i > 0) add_equivalents(vocabulary, walked[i], equal);
    for (const vocabulary::ClassNumber one : equal) {
      for (const auto& filed : directory_.requests().table().own(std::to_underlying(one), edition.generation)) {
        if (std::ranges::find(found, filed.stored) == found.end()) found.push_back(filed.stored);
        if (found.size() >= most) break;
      }
    }
    for (const vocabulary::ClassNumber child : vocabulary.children(walked[i])) {
      if (walked.size() >= max_searched_classes) break;
      if (std::ranges::find(walked, child) == walked.end()) walked.push_back(child);
    }
  }
  return walked.size();
}

bool Search::is_served(const SubscriptionEntry& subscription) const {
  const Request request = preparation_.prepare(subscription);
  bool is_served = false;
  directory_.visit_publications_for(subscription.subscription, request, [&](const StoredPublication& publication) {
    is_served = !directory_.offers().is_going(publication) &&
                judge_.judge(subscription, request, publication, editions_.in_force()).match.has_value();
    return is_served;
  });
  return is_served;
}

bool Search::is_used(const PublicationEntry& publication) const {
  const StoredPublication* stored = directory_.offers().table().find(publication.key);
  return stored != nullptr &&
         std::ranges::any_of(directory_.subscriptions_for(*stored), [&](const StoredSubscription* subscription) {
           return judge_.judge(*subscription, *stored).match.has_value();
         });
}

std::set<std::string> Search::converters_in_use() const {
  std::set<std::string> places;
  if (editions_.in_force().converters->is_empty()) return places;
  directory_.requests().table().visit_after(std::nullopt, [&](const StoredSubscription& subscription) {
    if (subscription.entry.subscription.convert == 0) return true;
    directory_.visit_publications_for(subscription, [&](const StoredPublication& publication) {
      const auto match = judge_.judge(subscription, publication).match;
      const auto chain = match && match->cost != 0 ? directory_.chain(subscription, publication) : nullptr;
      if (chain == nullptr || chain->via.empty()) return false;
      for (const auto step : std::views::split(chain->via, ',')) places.emplace(std::string_view(step));
      return false;
    });
    return true;
  });
  return places;
}

}  // namespace geminga::matching
