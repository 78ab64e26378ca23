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

Witnesses::Witnesses(const clauses::ClauseSet& set, const Program& program, const Graph& graph, Effort& effort)
    : set_(set), program_(program), graph_(graph), effort_(effort) {
  for (const clauses::AtLeast& one : set.at_leasts)
    is_composite_.push_back(program.counts() && set.roles.has_value() && !set.roles->is_simple(one.role));
}

bool Witnesses::satisfy(std::uint32_t at_least, NodeId node, std::uint32_t depth) {
  const clauses::AtLeast& one = set_.at_leasts[at_least];
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
