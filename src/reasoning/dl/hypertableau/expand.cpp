// At-least restrictions.
//
//   >=-rule:  >= n R.B(x), x not blocked, without n different R-neighbours in B: n new ones.
#include <algorithm>

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {

using clauses::number;

/// Whether a node was added, or a fact.
bool Tableau::Search::expand() {
  // As many are expanded at a time as pay for the look at what is blocked.
  constexpr std::size_t looked_an_expansion = 64;
  const std::size_t most = 1 + find_blocked() / looked_an_expansion;
  std::size_t expanded = 0;
  const std::size_t count = existentials_.size();
  // Without nominals nothing reaches into the models of earlier questions, where what is not done is blocked.
  const std::size_t settled = base_ && !program_.has_nominals() ? base_->existentials : 0;
  for (auto at = static_cast<std::uint32_t>(settled); at < count; ++at) {
    if (existentials_[at].is_done) continue;
    const Fact fact = graph_.fact(existentials_[at].fact);
    if (!graph_.is_active(fact.a) || graph_.node(fact.a).is_blocked) continue;
    if (has_witness(existentials_[at]) || !expand(at)) continue;
    ++expanded;
    // What follows from a guess is looked at before more is built on it.
    if (has_clash_ || is_over_limit() || (expanded >= most && branches_.size() > base_branches_)) break;
  }
  return expanded > 0;
}

/// The neighbours of which there may be one at most: what is known of them decides alternatives, which are chosen
/// after. Each existential is looked at once; what is blocked waits for its turn among all.
bool Tableau::Search::expand_functional() {
  if (next_functional_ == existentials_.size()) return false;
  bool has_expanded = false;
  bool has_looked = false;
  while (next_functional_ < existentials_.size() && !has_expanded) {
    const std::uint32_t at = next_functional_++;
    const Fact fact = graph_.fact(existentials_[at].fact);
    if (existentials_[at].is_done || fact.kind != FactKind::at_least || !graph_.is_active(fact.a)) continue;
    if (!is_functional(set_.at_leasts[fact.predicate].role, fact.a)) continue;
    if (!has_looked) find_blocked();
    has_looked = true;
    has_expanded = !graph_.node(fact.a).is_blocked && expand(at);
  }
  return has_expanded;
}

/// Whether a node was added, or a fact.
bool Tableau::Search::expand(std::uint32_t at) {
  const Fact fact = graph_.fact(existentials_[at].fact);
  existentials_[at].is_done = true;
  done_.push_back(at);
  if (is_satisfied(fact)) return false;
  if (fact.kind == FactKind::at_least) {
    expand_object(fact);
  } else {
    expand_data(fact);
  }
  return true;
}

bool Tableau::Search::has_witness(Existential& existential) {
  const Fact fact = graph_.fact(existential.fact);
  if (fact.kind != FactKind::at_least) return false;
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  const std::uint32_t property = number(at_least.role.property);
  const bool is_inverse = at_least.role.is_inverse;
  const Denials& denials = program_.denials();
  if (at_least.count != 1 || !denials.is_denial(number(at_least.filler))) return false;
  count_look();
  // A number may be that of another node since a branch was taken back: the edge is looked up again.
  const NodeId known = existential.witness;
  const bool is_known =
      known < graph_.node_count() && graph_.is_active(known) && graph_.node(known).version == existential.version &&
      graph_.find(FactKind::role, property, is_inverse ? known : fact.a, is_inverse ? fact.a : known) != none;
  if (is_known) return true;
  const auto is_denied = [&](NodeId node) {
    return std::ranges::any_of(denials.denied(number(at_least.filler)), [&](std::uint32_t id) {
      count_look();
      return graph_.find(FactKind::concept_of, id, node) != none;
    });
  };
  for (FactId id = is_inverse ? graph_.node(fact.a).in : graph_.node(fact.a).out; id != none;
       id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    count_look();
    const Fact& edge = graph_.fact(id);
    const NodeId node = is_inverse ? edge.a : edge.b;
    if (edge.kind != FactKind::role || edge.predicate != property || !graph_.is_active(node) || is_denied(node))
      continue;
    existential.witness = node;
    existential.version = graph_.node(node).version;
    return true;
  }
  return false;
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

/// What can be had without a new node is had at once: a clash that comes of it comes before more is guessed.
void Tableau::Search::note_existential(const Fact& fact, FactId id) {
  existentials_.push_back({id});
  if (fact.kind != FactKind::at_least) return;
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  const bool is_of_nominal = set_.concepts[number(at_least.filler)].kind == clauses::ConceptKind::nominal;
  if (at_least.count != 1 || is_of_nominal || !give_to_neighbour(fact)) return;
  existentials_.back().is_done = true;
  done_.push_back(static_cast<std::uint32_t>(existentials_.size() - 1));
}

bool Tableau::Search::is_functional(clauses::Role role, NodeId node) const {
  return std::ranges::any_of(program_.bounds_of_role(number(role.property)), [&](std::uint32_t id) {
    const Bound& bound = program_.bound(id);
    const bool is_plain = bound.filler == no_predicate && bound.unless == no_predicate && bound.count == 1;
    DependencySet dependency = no_dependency;
    return is_plain && bound.is_inverse == role.is_inverse && is_bound({node, id}, dependency);
  });
}

/// The neighbour that is there where there may be at most one.
std::optional<Tableau::Search::Neighbour> Tableau::Search::only_neighbour(clauses::Role role, NodeId node) {
  for (const std::uint32_t id : program_.bounds_of_role(number(role.property))) {
    const Bound& bound = program_.bound(id);
    const bool is_plain = bound.filler == no_predicate && bound.unless == no_predicate && bound.count == 1;
    DependencySet dependency = no_dependency;
    if (!is_plain || bound.is_inverse != role.is_inverse || !is_bound({node, id}, dependency)) continue;
    const std::vector<Neighbour> neighbours = counted({node, id});
    if (neighbours.empty()) return std::nullopt;
    return Neighbour{neighbours[0].node, unite(dependency, neighbours[0].dependency)};
  }
  return std::nullopt;
}

/// Where a property has at most one value, what must have the filler is the neighbour that is there.
bool Tableau::Search::give_to_neighbour(const Fact& fact) {
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  const auto neighbour = only_neighbour(at_least.role, fact.a);
  if (!neighbour) return false;
  apply({ChoiceKind::concept_of, number(at_least.filler), neighbour->node, neighbour->node},
        unite(neighbour->dependency, fact.dependency));
  return true;
}

void Tableau::Search::expand_data(const Fact& fact) {
  const clauses::DataAtLeast& at_least = set_.data_at_leasts[fact.predicate];
  const clauses::DataRange& range = set_.data_ranges[number(at_least.range)];
  const bool is_literal = number(at_least.range) > 1 && source_.kind(range.term) == owl::TermKind::literal;
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

}  // namespace geminga::hypertableau
