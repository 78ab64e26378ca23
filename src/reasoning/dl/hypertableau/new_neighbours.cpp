// How neighbours and values are made, with their edges and fillers.
#include "reasoning/dl/hypertableau/new_neighbours.hpp"

#include <utility>
#include <vector>

namespace geminga::hypertableau {

using clauses::number;

void NewNeighbours::make(const Fact& at_least) {
  if (at_least.kind == FactKind::at_least) {
    make_objects(at_least);
  } else {
    make_values(at_least);
  }
}

void NewNeighbours::share(const Fact& at_least, DependencySet dependency) {
  make_missing(at_least, sharing_.share(at_least, dependency), dependency);
}

NodeId NewNeighbours::make_plain(const Fact& at_least) {
  const NodeId node = facts_.add_node(NodeKind::tree, at_least.a, at_least.dependency);
  add_edge(at_least, node, at_least.dependency);
  return node;
}

bool NewNeighbours::is_functional(const Fact& at_least) const {
  return neighbours_.is_functional(program_.at_least(at_least.predicate).role, at_least.a);
}

void NewNeighbours::make_objects(const Fact& at_least) {
  DependencySet dependency = at_least.dependency;
  const std::uint32_t needed = program_.needed(at_least.predicate);
  if (needed == 1) {
    if (const auto individual = program_.nominal(number(program_.at_least(at_least.predicate).filler))) {
      const NodeId node = graph_.current(facts_.individuals()[number(*individual)], dependency);
      add_edge(at_least, node, dependency);
      return;
    }
    if (give_to_neighbour(at_least)) return;
  }
  std::vector<NodeId> known;
  if (needed > 1 && program_.counts()) known = sharing_.find_different(at_least, dependency);
  make_missing(at_least, known, dependency);
}

void NewNeighbours::make_missing(const Fact& at_least, std::span<const NodeId> known, DependencySet dependency) {
  const std::uint32_t filler = number(program_.at_least(at_least.predicate).filler);
  const std::uint32_t needed = program_.needed(at_least.predicate);
  const auto first = static_cast<NodeId>(graph_.node_count());
  for (std::size_t at = known.size(); at < needed; ++at) {
    const NodeId node = facts_.add_node(NodeKind::tree, at_least.a, dependency);
    add_edge(at_least, node, dependency);
    if (filler != number(clauses::thing)) facts_.add_fact(FactKind::concept_of, filler, node, 0, dependency);
    for (const NodeId other : known) facts_.add_unequal(other, node, dependency);
    if (effort_.is_over_limit()) return;
  }
  if (known.size() < needed) facts_.add_siblings(first, dependency);
}

void NewNeighbours::add_edge(const Fact& at_least, NodeId node, DependencySet dependency) {
  const clauses::Role role = program_.at_least(at_least.predicate).role;
  const auto [from, to] = role.is_inverse ? std::pair(node, at_least.a) : std::pair(at_least.a, node);
  facts_.add_fact(FactKind::role, number(role.property), from, to, dependency);
}

// If the property has at most one value, the neighbour in the graph must have the filler.
bool NewNeighbours::give_to_neighbour(const Fact& at_least) {
  const clauses::AtLeast& one = program_.at_least(at_least.predicate);
  const auto neighbour = neighbours_.only(one.role, at_least.a);
  if (!neighbour) return false;
  facts_.apply({ChoiceKind::concept_of, number(one.filler), neighbour->node, neighbour->node},
               graph_.unite(neighbour->dependency, at_least.dependency));
  return true;
}

void NewNeighbours::make_values(const Fact& at_least) {
  const clauses::DataAtLeast& one = program_.data_at_least(at_least.predicate);
  const std::uint32_t property = number(one.property);
  if (const auto literal = one.count == 1 ? facts_.literal_of(number(one.range)) : std::nullopt) {
    DependencySet dependency = at_least.dependency;
    const NodeId value = graph_.current(facts_.constant(*literal), dependency);
    facts_.add_fact(FactKind::data_role, property, at_least.a, value, dependency);
    return;
  }
  const auto first = static_cast<NodeId>(graph_.node_count());
  for (std::uint32_t at = 0; at < one.count; ++at) {
    const NodeId node = facts_.add_value(at_least.a);
    facts_.add_fact(FactKind::data_role, property, at_least.a, node, at_least.dependency);
    if (number(one.range) != 0) {
      facts_.add_fact(FactKind::data_range, number(one.range), node, 0, at_least.dependency);
    }
    if (effort_.is_over_limit()) return;
  }
  facts_.add_siblings(first, at_least.dependency);
}

}  // namespace geminga::hypertableau
