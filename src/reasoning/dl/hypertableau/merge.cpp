// Merging: two nodes are one.
//
//   ~-rule:  x = y: all that holds of the one holds of the other; what was under it in the tree goes, as its at-least
//            restrictions make it anew.
//   clash:   x = y and x != y
#include <algorithm>
#include <utility>

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {

/// Whether `node` stays and `other` goes. Roots stay, and what is higher in the tree; then what was there first.
bool Tableau::Search::is_kept(NodeId node, NodeId other) const {
  const auto rank = [this](NodeId id) {
    const Node& one = graph_.node(id);
    const bool is_fixed = one.kind == NodeKind::root || one.kind == NodeKind::constant;
    return std::tuple(!is_fixed, one.depth, id);
  };
  return rank(node) < rank(other);
}

void Tableau::Search::merge(const Merge& merge) {
  DependencySet dependency = merge.dependency;
  NodeId to = graph_.current(merge.a, sets_, dependency);
  NodeId from = graph_.current(merge.b, sets_, dependency);
  if (to == from || !graph_.is_active(to) || !graph_.is_active(from)) return;
  if (!is_kept(to, from)) std::swap(to, from);
  const FactId differ = graph_.find(FactKind::unequal, 0, std::min(to, from), std::max(to, from));
  if (differ != none) {
    clash(unite(dependency, graph_.fact(differ).dependency));
    return;
  }
  if (graph_.node(to).kind == NodeKind::constant && graph_.node(from).kind == NodeKind::constant) {
    const owl::TermId first{graph_.node(to).literal};
    const owl::TermId second{graph_.node(from).literal};
    if (values_.are_different(first, second)) {
      clash(dependency);
      return;
    }
    reason_ = "values whose equality is not known";
  }
  graph_.merge(from, to, dependency);
  copy_facts(from, to, dependency);
  if (graph_.node(to).kind == NodeKind::constant || graph_.node(to).kind == NodeKind::value) values_changed_ = true;
}

void Tableau::Search::copy_facts(NodeId from, NodeId to, DependencySet dependency) {
  std::vector<FactId> ids;
  for (FactId id = graph_.node(from).labels; id != none; id = graph_.fact(id).next_a) ids.push_back(id);
  for (FactId id = graph_.node(from).out; id != none; id = graph_.fact(id).next_a) ids.push_back(id);
  for (FactId id = graph_.node(from).in; id != none; id = graph_.fact(id).next_b) ids.push_back(id);
  for (FactId id = graph_.node(from).others; id != none; id = graph_.next_other(id, from)) ids.push_back(id);
  std::ranges::sort(ids);  // a self-loop is in two lists, and its copy is found there
  for (const FactId id : ids) {
    const Fact fact = graph_.fact(id);
    const bool has_second =
        fact.kind == FactKind::role || fact.kind == FactKind::data_role || fact.kind == FactKind::unequal;
    const NodeId a = fact.a == from ? to : fact.a;
    const NodeId b = has_second && fact.b == from ? to : fact.b;
    if (!graph_.is_active(a) || (has_second && !graph_.is_active(b))) continue;
    const DependencySet both = unite(fact.dependency, dependency);
    if (fact.kind == FactKind::unequal) {
      add_unequal(a, b, both);
      continue;
    }
    if (fact.kind == FactKind::data_range) {
      apply({ChoiceKind::data_range, fact.predicate, a, a}, both);
      continue;
    }
    add_fact(fact.kind, fact.predicate, a, b, both);
  }
}

}  // namespace geminga::hypertableau
