// Number restrictions: which neighbours count, when there are too many, and the NI rule.
//
//   <=-rule:  <= n R.B(x), R(x,y1), B(y1), ..., R(x,yn+1), B(yn+1): two of the y are equal.
//   NI-rule:  <= n R.B(x), R(x,y), B(y), x a root, y in the tree of something else: y is one of n roots of x, R and B,
//             or else trees that are repeated without end would give x more neighbours than it may have.
// After Motik, Shearer, Horrocks 2009, sections 3.2.3 and 4.2.
#include <algorithm>

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;

void Tableau::Search::suspect_role(std::uint32_t property, NodeId from, NodeId to, bool is_data) {
  for (const std::uint32_t bound :
       is_data ? program_.bounds_of_data_role(property) : program_.bounds_of_role(property)) {
    suspect(program_.bound(bound).is_inverse ? to : from, bound);
  }
}

void Tableau::Search::suspect_loop(std::uint32_t property, NodeId node) {
  for (const std::uint32_t bound : program_.bounds_of_loop(property)) suspect(node, bound);
}

void Tableau::Search::suspect_filler(std::uint32_t id, NodeId node) {
  for (const std::uint32_t bound : program_.bounds_of_filler(id)) {
    const Bound& one = program_.bound(bound);
    for (FactId edge = one.is_inverse ? graph_.node(node).out : graph_.node(node).in; edge != none;
         edge = one.is_inverse ? graph_.fact(edge).next_a : graph_.fact(edge).next_b) {
      const Fact& fact = graph_.fact(edge);
      if (fact.kind == FactKind::role && fact.predicate == one.property) {
        suspect(one.is_inverse ? fact.b : fact.a, bound);
      }
    }
  }
}

bool Tableau::Search::is_bound(const Suspect& suspect, DependencySet& dependency) const {
  dependency = no_dependency;
  if (program_.is_global(suspect.bound)) return true;
  const FactId fact = graph_.find(FactKind::at_most, suspect.bound, suspect.node);
  if (fact != none) dependency = graph_.fact(fact).dependency;
  return fact != none;
}

/// Whether a neighbour is counted, and because of what.
bool Tableau::Search::counts(const Bound& bound, NodeId node, DependencySet& dependency) {
  if (bound.filler != no_predicate) {
    const FactId filler = graph_.find(FactKind::concept_of, bound.filler, node);
    if (filler == none) return false;
    dependency = unite(dependency, graph_.fact(filler).dependency);
  }
  if (bound.unless == no_predicate) return true;
  const ChoiceKind kind = bound.is_data ? ChoiceKind::data_range : ChoiceKind::concept_of;
  return !holds({kind, bound.unless, node, node});
}

std::vector<Tableau::Search::Neighbour> Tableau::Search::counted(const Suspect& suspect) {
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
  std::ranges::sort(neighbours, {}, &Neighbour::node);
  return neighbours;
}

/// Whether more of them than the bound allows are known to differ from each other; if so, unites the reasons into
/// `dependency`. Each that differs from all that were taken is taken; other sets are not looked at.
bool Tableau::Search::exceeds(const Bound& bound, std::span<const Neighbour> neighbours, DependencySet& dependency) {
  if (bound.unless != no_predicate || neighbours.size() <= bound.count) return false;
  std::vector<NodeId> taken;
  DependencySet reasons = dependency;
  for (const Neighbour& one : neighbours) {
    DependencySet with_this = unite(reasons, one.dependency);
    const bool differs = std::ranges::all_of(taken, [&](NodeId other) {
      count_look();
      const auto [a, b] = std::minmax(one.node, other);
      const FactId fact = graph_.find(FactKind::unequal, 0, a, b);
      if (fact != none) with_this = unite(with_this, graph_.fact(fact).dependency);
      return fact != none;
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

void Tableau::Search::check(const Suspect& found) {
  DependencySet dependency = no_dependency;
  const Suspect suspect{graph_.current(found.node, sets_, dependency), found.bound};
  if (!graph_.is_active(suspect.node)) return;
  if (!is_bound(suspect, dependency)) {
    if (!program_.conditional(suspect.bound).empty()) check_conditional(suspect, no_dependency);
    return;
  }
  const Bound& bound = program_.bound(suspect.bound);
  const std::vector<Neighbour> neighbours = counted(suspect);
  if (introduce(suspect, neighbours, dependency) || neighbours.size() <= bound.count) return;
  if (bound.count == 1 && bound.unless == no_predicate) {
    for (std::size_t at = 1; at < neighbours.size(); ++at) {
      const DependencySet both = unite(neighbours[0].dependency, neighbours[at].dependency);
      merges_.push_back({neighbours[0].node, neighbours[at].node, unite(dependency, both)});
    }
    return;
  }
  if (exceeds(bound, neighbours, dependency)) {
    clash(dependency);
    return;
  }
  // A choice waits until all that is certain is derived.
  demands_.push_back(suspect);
}

/// NI-rule. True: the bound is looked at again.
bool Tableau::Search::introduce(const Suspect& suspect, std::span<const Neighbour> neighbours,
                                DependencySet dependency) {
  const Bound& bound = program_.bound(suspect.bound);
  if (bound.is_data || !program_.has_nominals() || graph_.node(suspect.node).kind != NodeKind::root) return false;
  for (const Neighbour& neighbour : neighbours) {
    const Node& node = graph_.node(neighbour.node);
    if (node.kind != NodeKind::tree || node.parent == suspect.node) continue;
    if (bound.count > 1 || bound.unless != no_predicate) {
      demands_.push_back(suspect);
      return true;
    }
    const NodeId root = introduced(suspect.node, suspect.bound, 0);
    merges_.push_back({neighbour.node, root, unite(dependency, neighbour.dependency)});
  }
  return !merges_.empty();
}

NodeId Tableau::Search::introduced(NodeId node, std::uint32_t bound, std::uint32_t number) {
  for (const Introduced& one : introduced_) {
    if (one.node == node && one.bound == bound && one.number == number) return one.root;
  }
  const NodeId root = add_node(NodeKind::root, none, no_dependency);
  introduced_.push_back({node, bound, number, root});
  return root;
}

void Tableau::Search::check_conditional(const Suspect& suspect, DependencySet dependency) {
  // guard -> alternatives or the bound, once the bound says anything.
  const Bound& bound = program_.bound(suspect.bound);
  const std::vector<Neighbour> neighbours = counted(suspect);
  const bool is_root = program_.has_nominals() && graph_.node(suspect.node).kind == NodeKind::root;
  if (neighbours.empty() || (neighbours.size() <= bound.count && !is_root)) return;
  for (const Neighbour& neighbour : neighbours) dependency = unite(dependency, neighbour.dependency);
  for (const ConditionalBound& rule : program_.conditional(suspect.bound)) {
    DependencySet reasons = dependency;
    const bool applies = std::ranges::all_of(rule.guard, [&](const Atom& atom) {
      const bool is_role = atom.kind == AtomKind::role;
      const FactId fact = is_role ? graph_.find(FactKind::role, atom.predicate, suspect.node, suspect.node)
                                  : graph_.find(FactKind::concept_of, atom.predicate, suspect.node);
      if (fact != none) reasons = unite(reasons, graph_.fact(fact).dependency);
      return fact != none;
    });
    if (!applies) continue;
    std::vector<Choice> alternatives;
    for (const Atom& atom : rule.alternatives) alternatives.push_back(choice_of(atom, suspect.node, suspect.node));
    alternatives.push_back({ChoiceKind::at_most, suspect.bound, suspect.node, suspect.node});
    if (std::ranges::any_of(alternatives, [this](const Choice& choice) { return holds(choice); })) continue;
    add_disjunction(alternatives, reasons);
  }
}

/// Makes the choice that a bound demands, if it still does.
void Tableau::Search::enforce(const Suspect& suspect, DependencySet dependency) {
  const Bound& bound = program_.bound(suspect.bound);
  DependencySet reasons = no_dependency;
  if (!is_bound(suspect, reasons)) return;
  reasons = unite(reasons, dependency);
  std::vector<Neighbour> neighbours = counted(suspect);
  std::vector<Choice> alternatives;
  const auto add_unless = [&](NodeId node) {
    if (bound.unless == no_predicate) return;
    const Choice choice{bound.is_data ? ChoiceKind::data_range : ChoiceKind::concept_of, bound.unless, node, node};
    if (!is_impossible(choice)) alternatives.push_back(choice);
  };
  const bool is_root = program_.has_nominals() && graph_.node(suspect.node).kind == NodeKind::root;
  const auto foreign = std::ranges::find_if(neighbours, [&](const Neighbour& one) {
    const Node& node = graph_.node(one.node);
    return is_root && node.kind == NodeKind::tree && node.parent != suspect.node;
  });
  if (foreign != neighbours.end()) {
    reasons = unite(reasons, foreign->dependency);
    add_unless(foreign->node);
    for (std::uint32_t at = 0; at < bound.count; ++at) {
      alternatives.push_back({ChoiceKind::introduce, at, foreign->node, suspect.node, suspect.bound});
    }
  } else {
    if (neighbours.size() <= bound.count) return;
    neighbours.resize(bound.count + 1);
    for (const Neighbour& one : neighbours) reasons = unite(reasons, one.dependency);
    for (std::size_t first = 0; first < neighbours.size(); ++first) {
      add_unless(neighbours[first].node);
      for (std::size_t second = first + 1; second < neighbours.size(); ++second) {
        const auto [a, b] = std::minmax(neighbours[first].node, neighbours[second].node);
        const FactId differ = graph_.find(FactKind::unequal, 0, a, b);
        if (differ != none) {
          reasons = unite(reasons, graph_.fact(differ).dependency);
        } else {
          alternatives.push_back({ChoiceKind::equal, 0, a, b});
        }
      }
    }
  }
  if (alternatives.empty()) {
    clash(reasons);
  } else if (alternatives.size() == 1) {
    apply(alternatives.front(), reasons);
    suspects_.push_back(suspect);
  } else {
    branch(std::move(alternatives), reasons, suspect);
  }
}

}  // namespace geminga::hypertableau
