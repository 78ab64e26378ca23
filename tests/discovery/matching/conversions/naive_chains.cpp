#include "discovery/matching/conversions/naive_chains.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "base/hash.hpp"
#include "discovery/matching/conditions/provider.hpp"
#include "discovery/matching/conversions/converter.hpp"

namespace geminga::matching {

using vocabulary::ClassNumber;

NaiveChains::NaiveChains(vocabulary::Vocabulary vocabulary, const registry::SubscriptionEntry& consumer,
                         const Offered& offered)
    : vocabulary_(std::move(vocabulary)) {
  if (!vocabulary_.is_loaded()) return;
  const vocabulary::StepGraph& declared = vocabulary_.conversions();
  for (std::uint32_t place = 0; place < declared.size(); ++place) ways_.push_back({declared.step(place), place, "-"});
  const Request request = prepared(consumer.subscription, vocabulary_);
  for (const auto& [arrival, entry] : offered) {
    const auto step = step_of(entry->publication.attributes, vocabulary_);
    if (!step) continue;
    const Imagined imagined(*entry, vocabulary_);
    if (!is_accepted_provider(consumer.subscription, *entry) || !is_accepted_protocol(consumer.subscription, *entry) ||
        !is_in_scope(consumer, request, imagined.offer) || !imagined.audience.condition ||
        !imagined.audience.condition->accepts(consumer)) {
      continue;
    }
    const Publication& publication = entry->publication;
    ways_.push_back({*step, 1000 + arrival,
                     publication.protocol + "://" + publication.address + ":" + std::to_string(publication.port) + "/" +
                         to_string(entry->key)});
  }
}

bool NaiveChains::leads_to(ClassNumber at, ClassNumber requested) const {
  std::set<const Way*> reached;
  for (bool is_more = true; is_more;) {
    is_more = false;
    for (const Way& way : ways_) {
      const bool follows =
          vocabulary_.is_subsumed(at, way.step.from) || std::ranges::any_of(reached, [&](const Way* before) {
            return vocabulary_.is_subsumed(before->step.to, way.step.from);
          });
      if (follows && reached.insert(&way).second) is_more = true;
    }
  }
  return std::ranges::any_of(reached, [&](const Way* way) { return vocabulary_.is_subsumed(way->step.to, requested); });
}

bool NaiveChains::is_better(const Trial& one, const Trial& other) {
  const auto rank = [](const Trial& trial) {
    std::vector<std::uint64_t> turns;
    for (const Way* way : trial.ways) turns.push_back(way->turn);
    std::ranges::reverse(turns);
    const auto services = std::ranges::count_if(trial.ways, [](const Way* way) { return way->step.is_service; });
    return std::tuple(trial.cost, services, trial.ways.size(), trial.distance, std::move(turns));
  };
  return rank(one) < rank(other);
}

void NaiveChains::extend(const Trial& trial, ClassNumber at, ClassNumber requested) {
  if (trial.ways.size() == vocabulary::max_chain_conversions) return;
  for (const Way& way : ways_) {
    if (!vocabulary_.is_subsumed(at, way.step.from)) continue;
    if (std::ranges::find(trial.ways, &way) != trial.ways.end()) continue;
    Trial longer = trial;
    longer.cost += way.step.cost;
    longer.distance += *vocabulary_.distance(at, way.step.from);
    longer.ways.push_back(&way);
    if (best_ && longer.cost > best_->cost) continue;
    if (vocabulary_.is_subsumed(way.step.to, requested)) {
      Trial whole = longer;
      whole.distance += *vocabulary_.distance(way.step.to, requested);
      if (!best_ || is_better(whole, *best_)) best_ = std::move(whole);
    }
    extend(longer, way.step.to, requested);
  }
}

std::shared_ptr<const vocabulary::Chain> NaiveChains::chain(ClassNumber offered, ClassNumber requested) {
  const auto [known, is_new] = known_.try_emplace({offered, requested});
  if (!is_new) return known->second;
  best_.reset();
  if (leads_to(offered, requested)) extend({}, offered, requested);
  if (!best_) return nullptr;
  auto chain = std::make_shared<vocabulary::Chain>();
  chain->cost = best_->cost;
  chain->distance = best_->distance;
  chain->classes.push_back(best_->ways.front()->step.from);
  bool has_service = false;
  for (const Way* way : best_->ways) {
    chain->classes.push_back(way->step.to);
    has_service |= way->step.is_service;
    chain->via += (chain->via.empty() ? "" : ",") + way->via;
  }
  if (!has_service) chain->via.clear();
  std::string names;
  for (const ClassNumber number : chain->classes) names.append(vocabulary_.iri(number)).append(" ");
  chain->mark = base::hash32(names);
  if (has_service) {
    chain->mark = base::hash32(std::to_string(chain->mark) + " " + std::to_string(chain->cost) + " " +
                               std::to_string(chain->distance) + " " + chain->via);
  }
  return known_[{offered, requested}] = chain;
}

}  // namespace geminga::matching
