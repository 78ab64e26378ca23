// Bounds and the neighbours that are there.
#include "reasoning/dl/hypertableau/facts/neighbours.hpp"

#include <algorithm>

namespace geminga::hypertableau {

using clauses::number;

bool Neighbours::is_bound(const Suspect& suspect, DependencySet& dependency) const {
  dependency = no_dependency;
  if (program_.is_global(suspect.bound)) return true;
  const FactId fact = graph_.find(FactKind::at_most, suspect.bound, suspect.node);
  if (fact != none) dependency = graph_.fact(fact).dependency;
  return fact != none;
}

bool Neighbours::meets(const Choice& choice) const {
  constexpr std::size_t most_looked_at = 64;
  const Directions& directions = program_.directions();
  std::span<const Direction> all;
  if (choice.kind == ChoiceKind::concept_of) all = directions.of_concept(choice.predicate);
  if (choice.kind == ChoiceKind::at_least) all = directions.of_at_least(choice.predicate);
  if (all.empty()) return false;
  std::size_t looked_at = 0;
  const auto is_spoken_of = [&](FactId id, bool is_inverse) {
    ++looked_at;
    effort_.count_look();
    const Fact& fact = graph_.fact(id);
    if (fact.kind == FactKind::at_least)
      return std::ranges::binary_search(all, directions.of_at_least(fact.predicate).front());
    return fact.kind == FactKind::role && std::ranges::binary_search(all, direction_of(fact.predicate, is_inverse));
  };
  const Node& node = graph_.node(choice.a);
  for (FactId id = node.others; id != none && looked_at < most_looked_at; id = graph_.next_other(id, choice.a)) {
    if (is_spoken_of(id, false)) return true;
  }
  for (FactId id = node.out; id != none && looked_at < most_looked_at; id = graph_.fact(id).next_a) {
    if (is_spoken_of(id, false)) return true;
  }
  for (FactId id = node.in; id != none && looked_at < most_looked_at; id = graph_.fact(id).next_b) {
    if (is_spoken_of(id, true)) return true;
  }
  return false;
}

bool Neighbours::crowds(const Choice& choice) {
  const auto is_exceeded = [&](std::uint32_t bound) {
    return counted({choice.a, bound}).size() > program_.bound(bound).count;
  };
  if (choice.kind == ChoiceKind::at_most) return is_exceeded(choice.predicate);
  return choice.kind == ChoiceKind::concept_of &&
         std::ranges::any_of(program_.bounds_of_guard(choice.predicate), [&](std::uint32_t bound) {
           return program_.brings(choice.predicate, bound) && is_exceeded(bound);
         });
}

// Whether the bound counts the neighbour. Unites the reasons into `dependency`.
bool Neighbours::counts(const Bound& bound, NodeId node, DependencySet& dependency) {
  if (bound.filler != no_predicate) {
    const FactId filler = graph_.find(FactKind::concept_of, bound.filler, node);
    if (filler == none) return false;
    dependency = unite(dependency, graph_.fact(filler).dependency);
  }
  if (bound.unless == no_predicate) return true;
  const ChoiceKind kind = bound.is_data ? ChoiceKind::data_range : ChoiceKind::concept_of;
  return !facts_.holds({kind, bound.unless, node, node});
}

std::vector<Neighbour> Neighbours::counted(const Suspect& suspect) {
  const Bound& bound = program_.bound(suspect.bound);
  const FactKind kind = bound.is_data ? FactKind::data_role : FactKind::role;
  std::vector<Neighbour> neighbours;
  for (FactId id = bound.is_inverse ? graph_.node(suspect.node).in : graph_.node(suspect.node).out; id != none;
       id = bound.is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    const Fact& fact = graph_.fact(id);
    const NodeId node = bound.is_inverse ? fact.a : fact.b;
    if (fact.kind != kind || fact.predicate != bound.property || !graph_.is_active(node)) continue;
    DependencySet dependency = fact.dependency;
    if (counts(bound, node, dependency)) neighbours.push_back({node, dependency});
  }
  effort_.count_aside(neighbours.size());
  std::ranges::sort(neighbours, {}, &Neighbour::node);
  return neighbours;
}

bool Neighbours::exceeds(const Bound& bound, std::span<const Neighbour> neighbours, DependencySet& dependency) {
  if (bound.unless != no_predicate || neighbours.size() <= bound.count) return false;
  std::vector<NodeId> taken;
  DependencySet reasons = dependency;
  for (const Neighbour& one : neighbours) {
    DependencySet with_this = unite(reasons, one.dependency);
    // Siblings differ from each other for one reason, and are the last that were taken, as nodes are ascending.
    const bool has_siblings = graph_.node(one.node).siblings != none;
    const NodeId first = has_siblings ? graph_.siblings_of(one.node).first : one.node;
    const auto others_end = std::ranges::lower_bound(taken, first);
    if (others_end != taken.end()) with_this = unite(with_this, graph_.siblings_of(one.node).dependency);
    const bool differs = std::all_of(taken.begin(), others_end, [&](NodeId other) {
      effort_.count_look();
      const auto difference = graph_.difference(one.node, other);
      if (difference) with_this = unite(with_this, *difference);
      return difference.has_value();
    });
    if (!differs) continue;
    reasons = with_this;
    taken.push_back(one.node);
    if (taken.size() <= bound.count) continue;
    dependency = reasons;
    return true;
  }
  return false;
}

FactId Neighbours::find_excluder(std::uint32_t id, NodeId node) const {
  const auto excluders = program_.disjoint_concepts(id);
  if (excluders.size() <= graph_.node(node).label_count) {
    for (const std::uint32_t other : excluders) {
      if (const FactId fact = graph_.find(FactKind::concept_of, other, node); fact != none) return fact;
    }
    return none;
  }
  for (FactId fact = graph_.node(node).labels; fact != none; fact = graph_.fact(fact).next_a) {
    if (std::ranges::binary_search(excluders, graph_.fact(fact).predicate)) return fact;
  }
  return none;
}

std::optional<DependencySet> Neighbours::membership(std::uint32_t filler, NodeId node) const {
  if (filler == number(clauses::thing)) return no_dependency;
  if (const FactId fact = graph_.find(FactKind::concept_of, filler, node); fact != none)
    return graph_.fact(fact).dependency;
  for (const std::uint32_t id : program_.unions().alternatives(filler)) {
    effort_.count_look();
    if (const FactId fact = graph_.find(FactKind::concept_of, id, node); fact != none)
      return graph_.fact(fact).dependency;
  }
  return std::nullopt;
}

std::optional<DependencySet> Neighbours::difference(NodeId a, NodeId b) {
  if (const auto known = graph_.difference(a, b)) return known;
  for (FactId label = graph_.node(a).labels; label != none; label = graph_.fact(label).next_a) {
    effort_.count_look();
    const std::uint32_t id = graph_.fact(label).predicate;
    if (program_.disjoint_concepts(id).empty()) continue;
    if (const FactId other = find_excluder(id, b); other != none)
      return unite(graph_.fact(label).dependency, graph_.fact(other).dependency);
  }
  return std::nullopt;
}

bool Neighbours::has_concepts(std::span<const std::uint32_t> concepts, NodeId node) const {
  return std::ranges::all_of(concepts, [&](std::uint32_t id) {
    effort_.count_look();
    return graph_.find(FactKind::concept_of, id, node) != none;
  });
}

bool Neighbours::is_denied(std::uint32_t denial, NodeId node) const {
  const auto holds = [&](std::uint32_t id) { return has_concepts(std::span(&id, 1), node); };
  const auto holds_with_neighbour = [&](const Forbidden& all) { return is_forbidden(all, node); };
  return std::ranges::any_of(program_.denials().denied(denial), holds) ||
         std::ranges::any_of(program_.denials().forbidden(denial), holds_with_neighbour);
}

bool Neighbours::is_forbidden(const Forbidden& all, NodeId node) const {
  if (!has_concepts(all.concepts, node)) return false;
  if (all.roles.empty()) return true;
  const clauses::Atom& first = all.roles.front();
  const bool is_out = first.first == clauses::centre;
  for (FactId id = is_out ? graph_.node(node).out : graph_.node(node).in; id != none;
       id = is_out ? graph_.fact(id).next_a : graph_.fact(id).next_b) {
    effort_.count_look();
    const Fact& edge = graph_.fact(id);
    const NodeId other = is_out ? edge.b : edge.a;
    if (edge.kind != FactKind::role || edge.predicate != first.predicate || !graph_.is_active(other)) continue;
    const bool has_roles = std::ranges::all_of(all.roles, [&](const clauses::Atom& role) {
      const bool leads_out = role.first == clauses::centre;
      return graph_.find(FactKind::role, role.predicate, leads_out ? node : other, leads_out ? other : node) != none;
    });
    if (has_roles && has_concepts(all.neighbour_concepts, other)) return true;
  }
  return false;
}

bool Neighbours::is_functional(clauses::Role role, NodeId node) const {
  return std::ranges::any_of(program_.bounds_of_role(number(role.property)), [&](std::uint32_t id) {
    DependencySet dependency = no_dependency;
    return is_of_functional(program_.bound(id), role) && is_bound({node, id}, dependency);
  });
}

std::optional<Neighbour> Neighbours::only(clauses::Role role, NodeId node) {
  for (const std::uint32_t id : program_.bounds_of_role(number(role.property))) {
    DependencySet dependency = no_dependency;
    if (!is_of_functional(program_.bound(id), role) || !is_bound({node, id}, dependency)) continue;
    const std::vector<Neighbour> neighbours = counted({node, id});
    if (neighbours.empty()) return std::nullopt;
    return Neighbour{neighbours[0].node, unite(dependency, neighbours[0].dependency)};
  }
  return std::nullopt;
}

}  // namespace geminga::hypertableau
