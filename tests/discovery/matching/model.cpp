#include "discovery/matching/model.hpp"

#include <algorithm>
#include <string>
#include <tuple>

#include "discovery/matching/conversions/naive_chains.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {

using registry::PublicationEntry;
using registry::SubscriptionEntry;

bool is_same(const Told& a, const Told& b) {
  if (a.about.index() != b.about.index()) return false;
  if (a.match.degree != b.match.degree || a.match.distance != b.match.distance) return false;
  if (a.about.index() == 0) {
    if (a.match != b.match) return false;
    // Scope and `for` are not told.
    PublicationEntry one = *std::get<0>(a.about);
    one.publication.scope = std::get<0>(b.about)->publication.scope;
    one.publication.for_whom = std::get<0>(b.about)->publication.for_whom;
    return one.same_as(*std::get<0>(b.about));
  }
  // Providers are not told what a consumer wants and has chosen, only that it has chosen them.
  const Subscription& other = std::get<1>(b.about)->subscription;
  SubscriptionEntry one = *std::get<1>(a.about);
  Subscription told = other;
  told.mode = one.subscription.mode;
  told.identity = one.subscription.identity;
  told.address = one.subscription.address;
  told.port = one.subscription.port;
  told.priority = one.subscription.priority;
  told.attributes = one.subscription.attributes;
  one.subscription = told;
  return one.same_as(*std::get<1>(b.about));
}

bool Model::is_kept_apart(const Identity& offered, const Identity& requested) const {
  const auto* number = std::get_if<NumericIdentity>(&offered);
  if (number == nullptr) number = std::get_if<NumericIdentity>(&requested);
  if (number == nullptr || offered.index() == requested.index()) return false;
  const auto named = concepts_.find(number->number);
  return named != concepts_.end() && named->second.size() > 1;
}

std::optional<Match> Model::met(const SubscriptionEntry& subscription, const Request& request,
                                const PublicationEntry& publication, const vocabulary::Vocabulary& by) const {
  const Imagined imagined(publication, by, placing_);
  const auto description = publications.find(description_key(publication.key.participant));
  if (description == publications.end()) return matching::meets(subscription, request, imagined.offer, by);
  const Imagined described(description->second, by, placing_);
  Offer offer = imagined.offer;
  offer.described_as = std::get_if<SemanticIdentity>(&description->second.publication.identity);
  offer.described_classes = &described.classes;
  return matching::meets(subscription, request, offer, by);
}

std::optional<Match> Model::meets(const SubscriptionEntry& subscription, const PublicationEntry& publication) const {
  if (is_kept_apart(publication.publication.identity, subscription.subscription.identity)) return std::nullopt;
  const bool is_former = former.contains(subscription.key);
  const vocabulary::Vocabulary& by = is_former ? former_ontology : ontology;
  return met(subscription, requests_.at(subscription.key), publication, by);
}

std::optional<Match> Model::would_meet(const SubscriptionEntry& subscription,
                                       const PublicationEntry& publication) const {
  if (is_kept_apart(publication.publication.identity, subscription.subscription.identity)) return std::nullopt;
  Request request = prepared(subscription.subscription, ontology, placing_, subscription.key.participant, overlapping);
  request.asks.chains = requests_.at(subscription.key).asks.chains;
  return met(subscription, request, publication, ontology);
}

void Model::work_out() {
  auto before = std::exchange(chosen_, {});
  requests_.clear();
  concepts_.clear();
  const auto note = [&](const Identity& identity) {
    if (std::holds_alternative<SemanticIdentity>(identity) && !has_expression(identity))
      concepts_[id32(identity)].insert(identity);
  };
  for (const auto& [key, entry] : publications) note(entry.publication.identity);
  for (const auto& [key, entry] : subscriptions) note(entry.subscription.identity);
  std::erase_if(arrival_, [&](const auto& one) { return !publications.contains(one.first); });
  NaiveChains::Offered offered;
  for (const auto& [key, entry] : publications) {
    const auto [arrival, is_new] = arrival_.try_emplace(key, arrivals_ + 1);
    if (is_new) ++arrivals_;
    offered.emplace_back(arrival->second, &entry);
  }
  for (const auto& [key, entry] : subscriptions) {
    const vocabulary::Vocabulary& by = former.contains(key) ? former_ontology : ontology;
    requests_[key] = prepared(entry.subscription, by, placing_, entry.key.participant, overlapping);
    if (entry.subscription.convert == 0) continue;
    requests_[key].asks.chains = [naive = std::make_shared<NaiveChains>(by, entry, offered)](auto from, auto to) {
      return naive->chain(from, to);
    };
  }
  for (const auto& [key, subscription] : subscriptions) {
    const auto& incumbents = before[key];
    // The only preferences that random_team_test.cpp draws: the favourite robot3, and the greatest rate.
    const Subscription& asked = subscription.subscription;
    const auto place = [&](const PublicationEntry& publication) {
      const bool is_behind = !asked.favoured.empty() && publication.participant_name != "robot3";
      const auto rate = publication.publication.attributes.find("rate");
      const std::int64_t wish = asked.prefer.empty()                               ? 0
                                : rate == publication.publication.attributes.end() ? 1
                                                                                   : -std::stoll(rate->second);
      const std::int64_t priority = -std::int64_t{publication.publication.priority};
      return asked.rank.empty() ? std::tuple(std::int64_t{is_behind}, priority, wish)
                                : std::tuple(wish, std::int64_t{is_behind}, priority);
    };
    using Sorted = std::tuple<std::tuple<std::int64_t, std::int64_t, std::int64_t>, Match, bool, ServiceKey>;
    std::vector<Sorted> candidates;
    for (const auto& [offer_key, publication] : publications) {
      if (const auto match = meets(subscription, publication)) {
        candidates.emplace_back(place(publication), *match, !incumbents.contains(offer_key), offer_key);
      }
    }
    std::ranges::sort(candidates);
    std::uint32_t limit = subscription.subscription.limit;
    if (!subscription.is_local && limit > 16) limit = 0;  // max_counted_providers: such a consumer takes all
    if (!subscription.is_local && !asked.chosen.empty()) {
      std::erase_if(candidates, [&](const Sorted& one) {
        return std::ranges::find(asked.chosen, std::get<ServiceKey>(one)) == asked.chosen.end();
      });
      limit = 0;
    }
    if (limit != 0 && candidates.size() > limit) candidates.resize(limit);
    for (const auto& [order, match, is_new, offer_key] : candidates) chosen_[key].emplace(offer_key, match);
  }
}

View Model::view() const {
  View view;
  for (const auto& [key, chosen] : chosen_) {
    const SubscriptionEntry& subscription = subscriptions.at(key);
    for (const auto& [offer_key, match] : chosen) {
      const PublicationEntry& publication = publications.at(offer_key);
      if (subscription.is_local)
        view[{key, offer_key}] = {std::make_shared<const PublicationEntry>(publication), match};
      if (publication.is_local && publication.publication.mode != ChannelMode::one_to_many_stream) {
        view[{offer_key, key}] = {std::make_shared<const SubscriptionEntry>(subscription), match};
      }
    }
  }
  return view;
}

std::string Replay::apply(const std::vector<Event>& events, Reason reason, const Model& model) {
  std::set<std::pair<ServiceKey, ServiceKey>> seen;
  std::map<ServiceKey, int> last;
  // Within a step each consumer is told first of services that do not match any longer, then of those that changed,
  // then of those that it gains, and last of those that are outranked.
  const auto turn = [](const Event& event) {
    if (event.change == Change::del) return event.reason == Reason::outranked ? 3 : 0;
    return event.change == Change::modify ? 1 : 2;
  };
  for (const Event& event : events) {
    if (!seen.emplace(event.to, key_of(event)).second) return in_words(event) + ": a second event about one pair";
    if (event.about.index() == 0) {
      if (last.contains(event.to) && last[event.to] > turn(event)) return in_words(event) + ": too late";
      last[event.to] = turn(event);
    }
    if (auto wrong = apply(event, reason, model); !wrong.empty()) return in_words(event) + ": " + wrong;
  }
  return {};
}

std::string Replay::apply(const Event& event, Reason reason, const Model& model) {
  const std::pair pair(event.to, key_of(event));
  const bool must_say_how = event.about.index() == 0 && event.change != Change::del;
  const std::uint32_t chain = event.chain == nullptr ? 0 : event.chain->mark;
  if (chain != (must_say_how ? event.match.chain : 0)) return "with another chain";
  const Told told{event.about, event.match};
  const auto known = view_.find(pair);
  if (event.change == Change::add) return view_.emplace(pair, told).second ? "" : "told already";
  if (known == view_.end()) return "was never told";
  if (event.change == Change::modify) {
    if (is_same(known->second, told)) return "nothing changed";
    known->second = told;
    return {};
  }
  if (!is_same(known->second, told)) return "not as last told";
  view_.erase(known);
  const bool is_offer = event.about.index() == 0;
  const auto publication = model.publications.find(is_offer ? key_of(event) : event.to);
  const auto subscription = model.subscriptions.find(is_offer ? event.to : key_of(event));
  Reason wanted = reason;
  if (publication != model.publications.end() && subscription != model.subscriptions.end()) {
    wanted = model.meets(subscription->second, publication->second) ? Reason::outranked : Reason::changed;
  }
  return event.reason == wanted ? "" : "should be " + std::string(to_string(wanted));
}

void Replay::forget(const ServiceKey& to) {
  std::erase_if(view_, [&to](const auto& row) { return row.first.first == to; });
}

std::string difference(const View& told, const View& wanted) {
  const auto words = [](const auto& pair) { return name(pair.first) + " about " + name(pair.second); };
  for (const auto& [pair, what] : wanted) {
    const auto known = told.find(pair);
    if (known == told.end()) return words(pair) + ": lost";
    if (!is_same(known->second, what)) return words(pair) + ": not as it is now";
  }
  for (const auto& [pair, what] : told) {
    if (!wanted.contains(pair)) return words(pair) + ": should be gone";
  }
  return {};
}

}  // namespace geminga::matching
