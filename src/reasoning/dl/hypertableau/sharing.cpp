// How neighbours are found that an at-least can share.
#include "reasoning/dl/hypertableau/sharing.hpp"

#include <algorithm>
#include <utility>

namespace geminga::hypertableau {

using clauses::number;

namespace {

/// The inequalities that are looked at or made for one at-least. Beyond it, neighbours are made.
constexpr std::size_t most_inequalities = 100'000;

}  // namespace

std::vector<NodeId> Sharing::find_different(const Fact& at_least, DependencySet& dependency) {
  const clauses::AtLeast& one = program_.at_least(at_least.predicate);
  const std::size_t needed = program_.needed(at_least.predicate);
  const bool is_inverse = one.role.is_inverse;
  std::vector<NodeId> found;
  for (FactId id = is_inverse ? graph_.node(at_least.a).in : graph_.node(at_least.a).out;
       id != none && found.size() + 1 < needed && found.size() * needed < most_inequalities;
       id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    const Fact& edge = graph_.fact(id);
    const NodeId node = is_inverse ? edge.a : edge.b;
    if (edge.kind != FactKind::role || edge.predicate != number(one.role.property) || !graph_.is_active(node)) continue;
    const auto membership = neighbours_.membership(number(one.filler), node);
    if (!membership) continue;
    DependencySet reasons = graph_.unite(graph_.unite(dependency, edge.dependency), *membership);
    const bool is_different = std::ranges::all_of(found, [&](NodeId other) {
      const auto difference = neighbours_.difference(node, other);
      if (difference) reasons = graph_.unite(reasons, *difference);
      return difference.has_value();
    });
    if (!is_different) continue;
    dependency = reasons;
    found.push_back(node);
  }
  return found;
}

bool Sharing::is_promising(const Fact& at_least) {
  if (records_.is_hopeless({ChoiceKind::share_neighbours, at_least.predicate})) return false;
  DependencySet ignored = no_dependency;
  return find_sharable(at_least).size() > find_different(at_least, ignored).size();
}

// The neighbours that are in the filler; if a bound has no room for as many as are missing, also those that it counts
// and that may be in the filler.
std::vector<NodeId> Sharing::find_sharable(const Fact& at_least) {
  std::vector<NodeId> found;
  add_members(at_least, found);
  const std::size_t needed = program_.needed(at_least.predicate);
  const std::size_t missing = needed - found.size();
  (void)program_.numbers().any_counting({at_least.predicate}, [&](std::uint32_t bound) {
    if (found.size() < needed) add_counted(at_least, bound, missing, found);
    return found.size() == needed;
  });
  while (found.size() * found.size() > most_inequalities) found.pop_back();
  return found;
}

void Sharing::add_members(const Fact& at_least, std::vector<NodeId>& found) const {
  const clauses::AtLeast& one = program_.at_least(at_least.predicate);
  const std::size_t needed = program_.needed(at_least.predicate);
  const bool is_inverse = one.role.is_inverse;
  for (FactId id = is_inverse ? graph_.node(at_least.a).in : graph_.node(at_least.a).out;
       id != none && found.size() < needed; id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    const Fact& edge = graph_.fact(id);
    const NodeId node = is_inverse ? edge.a : edge.b;
    if (edge.kind == FactKind::role && edge.predicate == number(one.role.property) && graph_.is_active(node) &&
        neighbours_.membership(number(one.filler), node))
      found.push_back(node);
  }
}

void Sharing::add_counted(const Fact& at_least, std::uint32_t bound, std::size_t missing, std::vector<NodeId>& found) {
  const std::size_t needed = program_.needed(at_least.predicate);
  DependencySet ignored = no_dependency;
  if (!numbers_.is_in_force(bound, at_least.a, ignored)) return;
  const std::vector<Neighbour> counted = neighbours_.counted({at_least.a, bound});
  if (counted.size() + missing <= program_.bound(bound).count) return;
  const std::uint32_t filler = number(program_.at_least(at_least.predicate).filler);
  for (const Neighbour& one : counted) {
    if (found.size() == needed) return;
    if (std::ranges::find(found, one.node) == found.end() && neighbours_.find_excluder(filler, one.node) == none)
      found.push_back(one.node);
  }
}

std::vector<NodeId> Sharing::share(const Fact& at_least, DependencySet dependency) {
  const clauses::AtLeast& one = program_.at_least(at_least.predicate);
  std::vector<NodeId> shared = find_sharable(at_least);
  for (std::size_t at = 0; at < shared.size(); ++at) {
    const NodeId node = shared[at];
    const auto [from, to] = one.role.is_inverse ? std::pair(node, at_least.a) : std::pair(at_least.a, node);
    facts_.add_fact(FactKind::role, number(one.role.property), from, to, dependency);
    if (!neighbours_.membership(number(one.filler), node))
      facts_.add_fact(FactKind::concept_of, number(one.filler), node, 0, dependency);
    for (std::size_t other = 0; other < at; ++other) {
      if (!neighbours_.difference(node, shared[other])) facts_.add_unequal(shared[other], node, dependency);
    }
  }
  return shared;
}

}  // namespace geminga::hypertableau
