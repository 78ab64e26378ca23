// At-least restrictions, and blocking, which keeps their expansion finite.
//
//   >=-rule:  >= n R.B(x), x not blocked, without n different R-neighbours in B: n new ones.
//   x is blocked by an older y that is not, if both are in the same concepts and so are their parents, with the same
//   edges between (pairwise anywhere blocking); where no clause looks back along an edge, the node alone is compared.
//   What is under a blocked node is blocked.
#include <algorithm>
#include <unordered_map>

#include "tableau/search.hpp"

namespace geminga::tableau {

using clauses::number;

/// Whether a node was added, or a fact.
bool Tableau::Search::expand() {
  find_blocked();
  bool has_expanded = false;
  const std::size_t count = existentials_.size();
  for (std::uint32_t at = 0; at < count; ++at) {
    if (existentials_[at].is_done) continue;
    const Fact fact = graph_.fact(existentials_[at].fact);
    if (!graph_.is_active(fact.a) || graph_.node(fact.a).is_blocked) continue;
    existentials_[at].is_done = true;
    done_.push_back(at);
    if (is_satisfied(fact)) continue;
    has_expanded = true;
    if (fact.kind == FactKind::at_least) {
      expand_object(fact);
    } else {
      expand_data(fact);
    }
    // What follows from a guess is looked at before more is built on it.
    if (has_clash_ || is_over_limit() || !branches_.empty()) break;
  }
  return has_expanded;
}

bool Tableau::Search::is_satisfied(const Fact& fact) {
  const bool is_data = fact.kind == FactKind::data_at_least;
  const std::uint32_t count =
      is_data ? set_.data_at_leasts[fact.predicate].count : set_.at_leasts[fact.predicate].count;
  const bool is_inverse = !is_data && set_.at_leasts[fact.predicate].role.is_inverse;
  const std::uint32_t property = is_data ? number(set_.data_at_leasts[fact.predicate].property)
                                         : number(set_.at_leasts[fact.predicate].role.property);
  const Choice filler = is_data ? Choice{ChoiceKind::data_range, number(set_.data_at_leasts[fact.predicate].range)}
                                : Choice{ChoiceKind::concept_of, number(set_.at_leasts[fact.predicate].filler)};
  const FactKind kind = is_data ? FactKind::data_role : FactKind::role;
  std::vector<NodeId> found;
  for (FactId id = is_inverse ? graph_.node(fact.a).in : graph_.node(fact.a).out; id != none && found.size() < count;
       id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    const Fact& edge = graph_.fact(id);
    const NodeId node = is_inverse ? edge.a : edge.b;
    if (edge.kind != kind || edge.predicate != property || !graph_.is_active(node)) continue;
    if (!holds({filler.kind, filler.predicate, node, node})) continue;
    const bool is_different = std::ranges::all_of(found, [&](NodeId other) {
      return graph_.find(FactKind::unequal, 0, std::min(node, other), std::max(node, other)) != none;
    });
    if (is_different) found.push_back(node);
  }
  return found.size() >= count;
}

void Tableau::Search::expand_object(const Fact& fact) {
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  const auto add_edge = [&](NodeId to, DependencySet dependency) {
    const auto [from, other] = at_least.role.is_inverse ? std::pair(to, fact.a) : std::pair(fact.a, to);
    add_fact(FactKind::role, number(at_least.role.property), from, other, dependency);
  };
  const clauses::Concept& filler = set_.concepts[number(at_least.filler)];
  if (at_least.count == 1) {
    if (filler.kind == clauses::ConceptKind::nominal) {
      DependencySet dependency = fact.dependency;
      const NodeId node = graph_.current(individuals_[number(filler.individual)], sets_, dependency);
      add_edge(node, dependency);
      return;
    }
    if (give_to_neighbour(fact)) return;
  }
  const auto first = static_cast<NodeId>(graph_.node_count());
  for (std::uint32_t at = 0; at < at_least.count; ++at) {
    const NodeId node = add_node(NodeKind::tree, fact.a, fact.dependency);
    add_edge(node, fact.dependency);
    if (at_least.filler != clauses::thing) {
      add_fact(FactKind::concept_of, number(at_least.filler), node, 0, fact.dependency);
    }
    for (NodeId other = first; other < node; ++other) add_unequal(other, node, fact.dependency);
    if (is_over_limit()) return;
  }
}

/// Where a property has at most one value, what must have the filler is the neighbour that is there.
bool Tableau::Search::give_to_neighbour(const Fact& fact) {
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  for (const std::uint32_t id : program_.bounds_of_role(number(at_least.role.property))) {
    const Bound& bound = program_.bound(id);
    const bool is_plain = bound.filler == no_predicate && bound.unless == no_predicate && bound.count == 1;
    DependencySet dependency = no_dependency;
    if (!is_plain || bound.is_inverse != at_least.role.is_inverse || !is_bound({fact.a, id}, dependency)) continue;
    const std::vector<Neighbour> neighbours = counted({fact.a, id});
    if (neighbours.empty()) return false;
    dependency = unite(unite(dependency, neighbours[0].dependency), fact.dependency);
    apply({ChoiceKind::concept_of, number(at_least.filler), neighbours[0].node, neighbours[0].node}, dependency);
    return true;
  }
  return false;
}

void Tableau::Search::expand_data(const Fact& fact) {
  const clauses::DataAtLeast& at_least = set_.data_at_leasts[fact.predicate];
  const clauses::DataRange& range = set_.data_ranges[number(at_least.range)];
  const bool is_literal = number(at_least.range) > 1 && source_.kind(range.term) == el::TermKind::literal;
  if (at_least.count == 1 && is_literal && !range.is_complement) {
    DependencySet dependency = fact.dependency;
    const NodeId value = graph_.current(constant(range.term), sets_, dependency);
    add_fact(FactKind::data_role, number(at_least.property), fact.a, value, dependency);
    return;
  }
  const auto first = static_cast<NodeId>(graph_.node_count());
  for (std::uint32_t at = 0; at < at_least.count; ++at) {
    const NodeId node = graph_.add_node(NodeKind::value, fact.a);
    add_fact(FactKind::data_role, number(at_least.property), fact.a, node, fact.dependency);
    if (number(at_least.range) != 0) {
      add_fact(FactKind::data_range, number(at_least.range), node, 0, fact.dependency);
    }
    for (NodeId other = first; other < node; ++other) add_unequal(other, node, fact.dependency);
    if (is_over_limit()) return;
  }
}

/// So many nodes are looked at in the time that a fact takes.
constexpr std::size_t nodes_a_step = 16;

void Tableau::Search::find_blocked() {
  // What is older than any change is as it was.
  const NodeId changed = graph_.take_changed();
  if (changed == none) return;
  steps_ += graph_.node_count() / nodes_a_step;  // or questions with many nodes would take no steps and no end
  std::unordered_map<std::uint64_t, NodeId> newest;
  std::vector<NodeId> older(graph_.node_count(), none);
  for (NodeId node = 0; node < graph_.node_count(); ++node) {
    const Node& one = graph_.node(node);
    if (one.kind != NodeKind::tree || one.state != NodeState::active) continue;
    if (node < changed && one.is_blocked) continue;
    if (node >= changed && graph_.node(one.parent).is_blocked) {
      graph_.set_blocked(node, true);
      continue;
    }
    std::uint64_t key = one.label_hash;
    if (program_.has_inverses()) {
      key = key * 0x9e3779b97f4a7c15U + one.edge_hash;
      key = key * 0x9e3779b97f4a7c15U + graph_.node(one.parent).label_hash;
    }
    const auto [found, is_new] = newest.try_emplace(key, none);
    bool is_blocked = false;
    for (NodeId blocker = found->second; node >= changed && blocker != none && !is_blocked; blocker = older[blocker]) {
      is_blocked = blocks(blocker, node);
    }
    graph_.set_blocked(node, is_blocked);
    if (is_blocked) continue;
    older[node] = found->second;
    found->second = node;
  }
}

bool Tableau::Search::blocks(NodeId blocker, NodeId node) const {
  if (!graph_.has_label_of(node, blocker)) return false;
  if (!program_.has_inverses()) return true;
  const NodeId parent = graph_.node(node).parent;
  const NodeId other = graph_.node(blocker).parent;
  return graph_.has_label_of(parent, other) && has_same_edges(node, blocker);
}

/// Whether the same roles lead between the nodes and their parents.
bool Tableau::Search::has_same_edges(NodeId node, NodeId other) const {
  const Node& first = graph_.node(node);
  const Node& second = graph_.node(other);
  if (first.edge_count != second.edge_count || first.edge_hash != second.edge_hash) return false;
  for (FactId id = second.in; id != none; id = graph_.fact(id).next_b) {
    const Fact& fact = graph_.fact(id);
    if (fact.kind != FactKind::role || fact.a != second.parent) continue;
    if (graph_.find(FactKind::role, fact.predicate, first.parent, node) == none) return false;
  }
  for (FactId id = second.out; id != none; id = graph_.fact(id).next_a) {
    const Fact& fact = graph_.fact(id);
    if (fact.kind != FactKind::role || fact.b != second.parent) continue;
    if (graph_.find(FactKind::role, fact.predicate, node, first.parent) == none) return false;
  }
  return true;
}

}  // namespace geminga::tableau
