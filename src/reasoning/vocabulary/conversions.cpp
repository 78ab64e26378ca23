// The cheapest chain by rounds: after round n, the cheapest of n + 1 conversions that ends with each.
#include "reasoning/vocabulary/conversions.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "base/hash.hpp"

namespace geminga::vocabulary {
namespace {

using taxonomy::ClassNumber;

constexpr std::uint32_t unreached = std::numeric_limits<std::uint32_t>::max();

/// The cheapest chain of a certain length that ends with a certain conversion.
struct Best {
  std::uint32_t cost = unreached;
  std::uint32_t before = unreached;  ///< the conversion before the last
};

ClassNumber from_of(const taxonomy::Conversion& one) { return ClassNumber{one.from}; }
ClassNumber to_of(const taxonomy::Conversion& one) { return ClassNumber{one.to}; }

}  // namespace

Conversions::Conversions(std::shared_ptr<const compiled::Ontology> ontology) : ontology_(std::move(ontology)) {
  for (const taxonomy::Conversion& one : ontology_->conversions()) {
    if (ontology_->is_satisfiable(from_of(one)) && ontology_->is_satisfiable(to_of(one))) conversions_.push_back(one);
  }
  next_.resize(conversions_.size());
  for (std::size_t at = 0; at < conversions_.size(); ++at) {
    for (std::size_t other = 0; other < conversions_.size(); ++other) {
      if (!ontology_->is_subsumed(to_of(conversions_[at]), from_of(conversions_[other]))) continue;
      next_[at].push_back(static_cast<std::uint32_t>(other));
    }
  }
}

std::shared_ptr<const Chain> Conversions::cheapest(ClassNumber offered, ClassNumber requested) const {
  if (conversions_.empty()) return nullptr;
  const std::pair pair(offered, requested);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = remembered_.find(pair); known != remembered_.end()) return known->second;
  }
  auto found = search(offered, requested);
  const std::lock_guard lock(mutex_);
  if (remembered_.size() >= max_remembered) remembered_.clear();
  remembered_.emplace(pair, found);
  return found;
}

std::shared_ptr<const Chain> Conversions::search(ClassNumber offered, ClassNumber requested) const {
  std::vector<bool> is_last(conversions_.size());
  std::vector<Best> first(conversions_.size());
  for (std::size_t at = 0; at < conversions_.size(); ++at) {
    const taxonomy::Conversion& one = conversions_[at];
    is_last[at] = ontology_->is_subsumed(to_of(one), requested);
    if (ontology_->is_subsumed(offered, from_of(one))) first[at].cost = one.cost;
  }
  std::vector<std::vector<Best>> rounds = {std::move(first)};
  std::uint32_t least = unreached;
  std::vector<std::uint32_t> steps;
  for (;;) {
    const std::vector<Best>& reached = rounds.back();
    for (std::uint32_t at = 0; at < reached.size(); ++at) {
      if (!is_last[at] || reached[at].cost >= least) continue;
      least = reached[at].cost;
      steps = {at};
      for (std::size_t round = rounds.size() - 1; round > 0; --round) {
        steps.push_back(rounds[round][steps.back()].before);
      }
    }
    if (rounds.size() == max_chain_conversions) break;
    std::vector<Best> further(conversions_.size());
    bool is_any_reached = false;
    for (std::uint32_t at = 0; at < reached.size(); ++at) {
      if (reached[at].cost == unreached) continue;
      for (const std::uint32_t next : next_[at]) {
        const std::uint32_t cost = reached[at].cost + conversions_[next].cost;
        if (cost >= further[next].cost || cost >= least) continue;
        further[next] = {cost, at};
        is_any_reached = true;
      }
    }
    if (!is_any_reached) break;
    rounds.push_back(std::move(further));
  }
  if (steps.empty()) return nullptr;
  std::ranges::reverse(steps);
  return std::make_shared<const Chain>(chain_of(steps, offered, requested));
}

Chain Conversions::chain_of(const std::vector<std::uint32_t>& steps, ClassNumber offered, ClassNumber requested) const {
  Chain chain;
  chain.classes.push_back(from_of(conversions_[steps.front()]));
  ClassNumber at = offered;
  for (const std::uint32_t step : steps) {
    const taxonomy::Conversion& one = conversions_[step];
    chain.distance += ontology_->distance(at, from_of(one)).value_or(0);
    chain.cost += one.cost;
    at = to_of(one);
    chain.classes.push_back(at);
  }
  chain.distance += ontology_->distance(at, requested).value_or(0);
  std::string names;
  for (const ClassNumber number : chain.classes) names.append(ontology_->iri(number)).append(" ");
  chain.mark = base::hash32(names);
  return chain;
}

}  // namespace geminga::vocabulary
