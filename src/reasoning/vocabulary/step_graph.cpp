// The cheapest way, found by rounds: after round n the cheapest way of n + 1 steps to each step is known.
#include "reasoning/vocabulary/step_graph.hpp"

#include <algorithm>
#include <limits>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "reasoning/compiled/ontology.hpp"

namespace geminga::vocabulary {

using taxonomy::ClassNumber;

namespace {

constexpr std::uint64_t unreached = std::numeric_limits<std::uint64_t>::max();
/// A weight is the cost, and below it the number of services.
constexpr unsigned service_bits = 8;

}  // namespace

/// The cheapest way of a certain length that ends with a certain step.
struct StepGraph::Best {
  std::uint64_t weight = unreached;
  std::uint32_t distance = 0;
  std::uint32_t before = 0;  ///< the step before the last
  [[nodiscard]] bool is_better_than(const Best& other) const {
    return weight != other.weight ? weight < other.weight : distance < other.distance;
  }
};

std::uint64_t StepGraph::weight_of(const Step& step) {
  return (std::uint64_t{step.cost} << service_bits) + (step.is_service ? 1 : 0);
}

std::uint32_t StepGraph::climb(ClassNumber from, ClassNumber to) const {
  return ontology_->distance(from, to).value_or(0);
}

void StepGraph::put(std::uint32_t place, const Step& step, std::uint64_t turn) {
  GEMINGA_ASSERT(!has(place));
  if (place >= steps_.size()) steps_.resize(place + 1U);
  steps_[place] = {.step = step, .turn = turn, .is_there = true};
  const auto behind_it = std::ranges::upper_bound(order_, turn, {}, [this](auto other) { return steps_[other].turn; });
  order_.insert(behind_it, place);
  for (const std::uint32_t other : order_) {
    const Step& one = steps_[other].step;
    if (ontology_->is_subsumed(step.to, one.from)) steps_[place].next.push_back({other, climb(step.to, one.from)});
    if (other == place) continue;
    if (ontology_->is_subsumed(one.to, step.from)) steps_[other].next.push_back({place, climb(one.to, step.from)});
  }
}

void StepGraph::erase(std::uint32_t place) {
  GEMINGA_ASSERT(has(place));
  std::erase(order_, place);
  for (const std::uint32_t other : order_) {
    std::erase_if(steps_[other].next, [place](const Next& next) { return next.place == place; });
  }
  steps_[place] = {};
}

bool StepGraph::go_on(const Round& reached, std::uint64_t least, const Usable& usable, Round& further) const {
  bool is_any_reached = false;
  for (const std::uint32_t at : order_) {
    if (reached[at].weight == unreached) continue;
    for (const auto& [next, distance] : steps_[at].next) {
      const Best best{reached[at].weight + weight_of(steps_[next].step), reached[at].distance + distance, at};
      if (!best.is_better_than(further[next]) || best.weight >= least || (usable && !usable(next))) continue;
      further[next] = best;
      is_any_reached = true;
    }
  }
  return is_any_reached;
}

std::vector<std::uint32_t> StepGraph::cheapest(ClassNumber offered, ClassNumber requested, const Usable& usable) const {
  std::vector<bool> is_last(steps_.size());
  Round first(steps_.size());
  for (const std::uint32_t at : order_) {
    if (usable && !usable(at)) continue;
    const Step& one = steps_[at].step;
    is_last[at] = ontology_->is_subsumed(one.to, requested);
    if (ontology_->is_subsumed(offered, one.from)) first[at] = {weight_of(one), climb(offered, one.from), 0};
  }
  std::vector<Round> rounds = {std::move(first)};
  std::uint64_t least = unreached;
  std::vector<std::uint32_t> way;
  for (;;) {
    const Round& reached = rounds.back();
    Best best{.weight = least};  // a way that is longer must be cheaper
    for (const std::uint32_t at : order_) {
      if (!is_last[at] || reached[at].weight > best.weight || reached[at].weight == least) continue;
      const Best one{reached[at].weight, reached[at].distance + climb(steps_[at].step.to, requested), 0};
      if (!one.is_better_than(best)) continue;
      best = one;
      way = {at};
      for (std::size_t round = rounds.size() - 1; round > 0; --round) way.push_back(rounds[round][way.back()].before);
    }
    least = best.weight;
    if (rounds.size() == max_chain_conversions) break;
    Round further(steps_.size());
    if (!go_on(reached, least, usable, further)) break;
    rounds.push_back(std::move(further));
  }
  std::ranges::reverse(way);
  return way;
}

std::vector<std::pair<ClassNumber, std::uint32_t>> StepGraph::behind(std::uint32_t place) const {
  GEMINGA_ASSERT(has(place));
  std::vector<std::uint64_t> least(steps_.size(), unreached);
  Round reached(steps_.size());
  reached[place].weight = least[place] = weight_of(steps_[place].step);
  for (std::size_t length = 1; length < max_chain_conversions; ++length) {
    Round further(steps_.size());
    if (!go_on(reached, unreached, {}, further)) break;
    for (const std::uint32_t at : order_) least[at] = std::min(least[at], further[at].weight);
    reached = std::move(further);
  }
  std::vector<std::pair<ClassNumber, std::uint32_t>> led_to;
  for (const std::uint32_t at : order_) {
    if (least[at] == unreached) continue;
    led_to.emplace_back(steps_[at].step.to, static_cast<std::uint32_t>(least[at] >> service_bits));
  }
  return led_to;
}

Chain StepGraph::chain_of(const std::vector<std::uint32_t>& way, ClassNumber offered, ClassNumber requested) const {
  Chain chain;
  chain.classes.push_back(steps_[way.front()].step.from);
  ClassNumber at = offered;
  for (const std::uint32_t place : way) {
    const Step& one = steps_[place].step;
    chain.distance += ontology_->distance(at, one.from).value_or(0);
    chain.cost += one.cost;
    at = one.to;
    chain.classes.push_back(at);
  }
  chain.distance += ontology_->distance(at, requested).value_or(0);
  std::string names;
  for (const ClassNumber number : chain.classes) names.append(ontology_->iri(number)).append(" ");
  chain.mark = base::hash32(names);
  return chain;
}

}  // namespace geminga::vocabulary
