// The search for neighbours, along paths, and for the parts of fillers.
#include "reasoning/dl/hypertableau/witnesses.hpp"

#include <algorithm>
#include <unordered_set>

namespace geminga::hypertableau {

using clauses::AtomKind;
using clauses::number;

namespace {

/// Fillers within fillers are looked for so deep.
constexpr std::uint32_t max_depth = 8;

/// Calls `use` for each active neighbour by the role until it returns true, and returns whether it did.
template <typename Use>
bool any_neighbour(const Graph& graph, Effort& effort, clauses::Role role, NodeId node, Use&& use) {
  for (FactId id = role.is_inverse ? graph.node(node).in : graph.node(node).out; id != none;
       id = role.is_inverse ? graph.fact(id).next_b : graph.fact(id).next_a) {
    effort.count_look();
    const Fact& edge = graph.fact(id);
    if (edge.kind != FactKind::role || edge.predicate != number(role.property)) continue;
    const NodeId other = role.is_inverse ? edge.a : edge.b;
    if (graph.is_active(other) && use(other)) return true;
  }
  return false;
}

}  // namespace

Witnesses::Witnesses(const clauses::ClauseSet& set, const Program& program, const Graph& graph, Effort& effort,
                     Assertions& facts, Neighbours& neighbours)
    : set_(set), program_(program), graph_(graph), effort_(effort), facts_(facts), neighbours_(neighbours) {
  for (const clauses::AtLeast& one : set.at_leasts)
    is_composite_.push_back(program.counts() && set.roles.has_value() && !set.roles->is_simple(one.role));
}

bool Witnesses::satisfy(const Fact& at_least) {
  if (at_least.kind == FactKind::data_at_least) return satisfy_data(at_least);
  return program_.needed(at_least.predicate) == 1 ? satisfy(at_least.predicate, at_least.a, 0)
                                                  : satisfy_several(at_least);
}

bool Witnesses::satisfy_several(const Fact& at_least) {
  const clauses::AtLeast& one = program_.at_least(at_least.predicate);
  const std::uint32_t filler = number(one.filler);
  const std::uint32_t needed = program_.needed(at_least.predicate);
  const bool is_inverse = one.role.is_inverse;
  std::vector<NodeId> found;
  for (FactId id = is_inverse ? graph_.node(at_least.a).in : graph_.node(at_least.a).out;
       id != none && found.size() < needed; id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    const Fact& edge = graph_.fact(id);
    const NodeId node = is_inverse ? edge.a : edge.b;
    if (edge.kind != FactKind::role || edge.predicate != number(one.role.property) || !graph_.is_active(node)) continue;
    const bool is_in = program_.counts() ? neighbours_.membership(filler, node).has_value()
                                         : facts_.holds({ChoiceKind::concept_of, filler, node, node});
    if (is_in && differs_from_all(node, found)) found.push_back(node);
  }
  return found.size() >= needed;
}

bool Witnesses::satisfy_data(const Fact& at_least) {
  const clauses::DataAtLeast& one = program_.data_at_least(at_least.predicate);
  std::vector<NodeId> found;
  for (FactId id = graph_.node(at_least.a).out; id != none && found.size() < one.count; id = graph_.fact(id).next_a) {
    const Fact& edge = graph_.fact(id);
    if (edge.kind != FactKind::data_role || edge.predicate != number(one.property) || !graph_.is_active(edge.b))
      continue;
    const bool is_in = facts_.holds({ChoiceKind::data_range, number(one.range), edge.b, edge.b});
    if (is_in && differs_from_all(edge.b, found)) found.push_back(edge.b);
  }
  return found.size() >= one.count;
}

bool Witnesses::differs_from_all(NodeId node, const std::vector<NodeId>& others) {
  return std::ranges::all_of(others, [&](NodeId other) { return neighbours_.difference(node, other).has_value(); });
}

bool Witnesses::satisfy(std::uint32_t at_least, NodeId node, std::uint32_t depth) {
  const clauses::AtLeast& one = program_.at_least(at_least);
  const bool is_individual = graph_.node(node).kind == NodeKind::root;
  const auto is_witness = [&](NodeId other) {
    const bool may_be = depth == 0 || graph_.node(other).kind == NodeKind::root;
    return may_be && is_in(number(one.filler), other, is_individual, depth);
  };
  return any_neighbour(graph_, effort_, one.role, node, is_witness) ||
         (is_individual && is_composite_[at_least] && has_path(one, node, depth));
}

// Breadth first, because most paths are short.
bool Witnesses::has_path(const clauses::AtLeast& one, NodeId node, std::uint32_t depth) {
  using Move = owl::Automaton::Move;
  const owl::Automaton& automaton = set_.roles->automaton(one.role);
  std::vector<std::pair<owl::Automaton::State, NodeId>> places = {{owl::Automaton::begin, node}};
  std::unordered_set<std::uint64_t> seen;
  for (std::size_t at = 0; at < places.size(); ++at) {
    const auto [state, place] = places[at];
    for (const Move& move : std::ranges::equal_range(automaton.moves(), state, {}, &Move::from)) {
      const bool is_found = any_neighbour(graph_, effort_, move.label, place, [&](NodeId next) {
        if (graph_.node(next).kind != NodeKind::root) return false;
        if (!seen.insert((std::uint64_t{move.to} << 32) | next).second) return false;
        places.emplace_back(move.to, next);
        return automaton.is_final(move.to) && is_in(number(one.filler), next, true, depth);
      });
      if (is_found) return true;
    }
  }
  return false;
}

bool Witnesses::is_in(std::uint32_t filler, NodeId node, bool looks_around, std::uint32_t depth) {
  if (filler == number(clauses::thing) || graph_.find(FactKind::concept_of, filler, node) != none) return true;
  if (!program_.counts() || !program_.parts().has_parts(filler) || depth == max_depth) return false;
  const bool is_individual = looks_around && graph_.node(node).kind == NodeKind::root;
  return std::ranges::all_of(program_.parts().of(filler), [&](const clauses::Atom& part) {
    if (part.kind == AtomKind::concept_of) return is_in(part.predicate, node, looks_around, depth + 1);
    if (graph_.find(FactKind::at_least, part.predicate, node) != none) return true;
    return is_individual && program_.needed(part.predicate) == 1 && satisfy(part.predicate, node, depth + 1);
  });
}

}  // namespace geminga::hypertableau
