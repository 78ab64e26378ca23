// How bounds are looked at and enforced. The rules are in bounds.hpp.
#include "reasoning/dl/hypertableau/bounds.hpp"

#include <algorithm>
#include <utility>

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;

void Bounds::restore(const Sizes& sizes) {
  demands_.resize(sizes.demands);
  next_demand_ = sizes.next;
  suspects_.clear();
}

bool Bounds::contradicts(const Choice& restriction, DependencySet dependency) {
  if (!numbers_.excludes(restriction, dependency)) return false;
  facts_.clash(dependency);
  return true;
}

void Bounds::note_role(std::uint32_t property, NodeId from, NodeId to, bool is_data) {
  for (const std::uint32_t bound :
       is_data ? program_.bounds_of_data_role(property) : program_.bounds_of_role(property)) {
    note({program_.bound(bound).is_inverse ? to : from, bound});
  }
}

void Bounds::note_loop(std::uint32_t property, NodeId node) {
  for (const std::uint32_t bound : program_.bounds_of_loop(property)) note({node, bound});
}

void Bounds::note_concept(std::uint32_t id, NodeId node) {
  for (const std::uint32_t bound : program_.bounds_of_filler(id)) {
    const Bound& one = program_.bound(bound);
    for (FactId edge = one.is_inverse ? graph_.node(node).out : graph_.node(node).in; edge != none;
         edge = one.is_inverse ? graph_.fact(edge).next_a : graph_.fact(edge).next_b) {
      const Fact& fact = graph_.fact(edge);
      if (fact.kind == FactKind::role && fact.predicate == one.property) {
        note({one.is_inverse ? fact.b : fact.a, bound});
      }
    }
  }
  for (const std::uint32_t bound : program_.bounds_of_guard(id)) note({node, bound});
  for (const std::uint32_t bound : program_.bounds_of_guard(id)) {
    DependencySet reasons = no_dependency;
    if (numbers_.is_exceeded(bound, node, reasons)) return facts_.clash(reasons);
  }
}

void Bounds::check_last() {
  DependencySet dependency = no_dependency;
  const Suspect found = suspects_.back();
  suspects_.pop_back();
  const Suspect suspect{graph_.current(found.node, dependency), found.bound};
  if (!graph_.is_active(suspect.node)) return;
  if (!neighbours_.is_bound(suspect, dependency)) {
    if (!program_.conditional(suspect.bound).empty()) check_conditional(suspect);
    return;
  }
  const Bound& bound = program_.bound(suspect.bound);
  const std::vector<Neighbour> neighbours = neighbours_.counted(suspect);
  if (introduce(suspect, neighbours, dependency) || neighbours.size() <= bound.count) return;
  if (bound.count == 1 && bound.unless == no_predicate) {
    for (std::size_t at = 1; at < neighbours.size(); ++at) {
      const DependencySet both = unite(neighbours[0].dependency, neighbours[at].dependency);
      facts_.add_merge(neighbours[0].node, neighbours[at].node, unite(dependency, both));
    }
    return;
  }
  if (neighbours_.exceeds(bound, neighbours, dependency)) {
    facts_.clash(dependency);
    return;
  }
  // A choice waits until all that is certain is derived.
  demands_.push_back(suspect);
}

// Whether the NI-rule is for the neighbour of a root.
bool Bounds::is_foreign(NodeId neighbour, NodeId of) const {
  const Node& node = graph_.node(neighbour);
  return node.kind == NodeKind::tree && node.parent != of;
}

// NI-rule. True: the bound is looked at again.
bool Bounds::introduce(const Suspect& suspect, std::span<const Neighbour> neighbours, DependencySet dependency) {
  const Bound& bound = program_.bound(suspect.bound);
  if (bound.is_data || !program_.has_nominals() || graph_.node(suspect.node).kind != NodeKind::root) return false;
  for (const Neighbour& neighbour : neighbours) {
    if (!is_foreign(neighbour.node, suspect.node)) continue;
    if (bound.count > 1 || bound.unless != no_predicate) {
      demands_.push_back(suspect);
      return true;
    }
    const NodeId root = facts_.introduced(suspect.node, suspect.bound, 0);
    facts_.add_merge(neighbour.node, root, unite(dependency, neighbour.dependency));
  }
  return facts_.has_merges();
}

// guard -> alternatives or the bound, once the bound says anything.
void Bounds::check_conditional(const Suspect& suspect) {
  const Bound& bound = program_.bound(suspect.bound);
  // Most nodes have no guard, so the neighbours are counted behind it.
  std::optional<DependencySet> reasons_of_count;
  for (const ConditionalBound& rule : program_.conditional(suspect.bound)) {
    DependencySet reasons = no_dependency;
    const bool applies = std::ranges::all_of(rule.guard, [&](const Atom& atom) {
      const bool is_role = atom.kind == AtomKind::role;
      const FactId fact = is_role ? graph_.find(FactKind::role, atom.predicate, suspect.node, suspect.node)
                                  : graph_.find(FactKind::concept_of, atom.predicate, suspect.node);
      if (fact != none) reasons = unite(reasons, graph_.fact(fact).dependency);
      return fact != none;
    });
    if (!applies) continue;
    if (!reasons_of_count) {
      const std::vector<Neighbour> neighbours = neighbours_.counted(suspect);
      const bool is_root = program_.has_nominals() && graph_.node(suspect.node).kind == NodeKind::root;
      if (neighbours.empty() || (neighbours.size() <= bound.count && !is_root)) return;
      reasons_of_count = no_dependency;
      for (const Neighbour& neighbour : neighbours) reasons_of_count = unite(*reasons_of_count, neighbour.dependency);
    }
    reasons = unite(reasons, *reasons_of_count);
    std::vector<Choice> alternatives;
    for (const Atom& atom : rule.alternatives) {
      alternatives.push_back(choice_of(program_, atom, suspect.node, suspect.node));
    }
    alternatives.push_back({ChoiceKind::at_most, suspect.bound, suspect.node, suspect.node});
    if (std::ranges::any_of(alternatives, [this](const Choice& choice) { return facts_.holds(choice); })) continue;
    disjunctions_.add(alternatives, reasons);
  }
}

std::optional<Bounds::Demand> Bounds::next_demand() {
  while (next_demand_ < demands_.size()) {
    Demand demand{demands_[next_demand_++]};
    demand.suspect.node = graph_.current(demand.suspect.node, demand.dependency);
    if (graph_.is_active(demand.suspect.node)) return demand;
  }
  return std::nullopt;
}

std::optional<Decision> Bounds::enforce(const Demand& demand) {
  const Suspect& suspect = demand.suspect;
  const Bound& bound = program_.bound(suspect.bound);
  DependencySet reasons = no_dependency;
  if (!neighbours_.is_bound(suspect, reasons)) return std::nullopt;
  reasons = unite(reasons, demand.dependency);
  std::vector<Neighbour> neighbours = neighbours_.counted(suspect);
  std::vector<Choice> alternatives;
  const bool is_root = program_.has_nominals() && graph_.node(suspect.node).kind == NodeKind::root;
  const auto foreign = std::ranges::find_if(
      neighbours, [&](const Neighbour& one) { return is_root && is_foreign(one.node, suspect.node); });
  if (foreign != neighbours.end()) {
    reasons = unite(reasons, foreign->dependency);
    add_introductions(suspect, foreign->node, alternatives);
  } else {
    if (neighbours.size() <= bound.count) return std::nullopt;
    neighbours.resize(bound.count + 1);
    if (!add_equalities(bound, neighbours, alternatives, reasons)) return std::nullopt;
  }
  if (alternatives.empty()) {
    facts_.clash(reasons);
    return std::nullopt;
  }
  if (alternatives.size() > 1) return Decision{std::move(alternatives), reasons, suspect};
  facts_.apply(alternatives.front(), reasons);
  note(suspect);
  return std::nullopt;
}

// The neighbour may be one that the bound does not count.
void Bounds::add_unless(const Bound& bound, NodeId node, std::vector<Choice>& alternatives) {
  if (bound.unless == no_predicate) return;
  const Choice choice{bound.is_data ? ChoiceKind::data_range : ChoiceKind::concept_of, bound.unless, node, node};
  if (!facts_.is_impossible(choice)) alternatives.push_back(choice);
}

// NI-rule
void Bounds::add_introductions(const Suspect& suspect, NodeId foreign, std::vector<Choice>& alternatives) {
  const Bound& bound = program_.bound(suspect.bound);
  add_unless(bound, foreign, alternatives);
  for (std::uint32_t at = 0; at < bound.count; ++at) {
    alternatives.push_back({ChoiceKind::introduce, at, foreign, suspect.node, suspect.bound});
  }
}

// <=-rule. Unites into `reasons` why there are as many neighbours, and why some are not equal.
bool Bounds::add_equalities(const Bound& bound, std::span<const Neighbour> neighbours,
                            std::vector<Choice>& alternatives, DependencySet& reasons) {
  for (const Neighbour& one : neighbours) reasons = unite(reasons, one.dependency);
  for (std::size_t first = 0; first < neighbours.size(); ++first) {
    add_unless(bound, neighbours[first].node, alternatives);
    effort_.count_aside(neighbours.size() - first);
    if (effort_.is_over_limit()) return false;
    for (std::size_t second = first + 1; second < neighbours.size(); ++second) {
      const auto [a, b] = std::minmax(neighbours[first].node, neighbours[second].node);
      if (const auto difference = neighbours_.difference(a, b)) {
        reasons = unite(reasons, *difference);
      } else {
        alternatives.push_back({ChoiceKind::equal, 0, a, b});
      }
    }
  }
  return true;
}

}  // namespace geminga::hypertableau
