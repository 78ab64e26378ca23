// Facts, and merging: two nodes are one.
//
//   ~-rule:  x = y: the facts of one node are copied to the other. The subtree of the node that goes is pruned, because
//            its at-least restrictions make it again.
//   clash:   x = y and x != y
#include "reasoning/dl/hypertableau/facts/assertions.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/sorted.hpp"

namespace geminga::hypertableau {

using clauses::number;

Assertions::Assertions(const owl::Ontology& source, const clauses::ClauseSet& set, const Program& program, Graph& graph,
                       Effort& effort)
    : program_(program),
      graph_(graph),
      effort_(effort),
      values_(source, set),
      has_individuals_(!set.individuals.empty()) {}

void Assertions::clash(DependencySet dependency) {
  if (has_clash_) return;
  has_clash_ = true;
  clash_ = dependency;
}

void Assertions::restore(std::size_t introduced) {
  introduced_.resize(introduced);
  merges_.clear();
  have_values_changed_ = false;
}

void Assertions::clear() {
  has_clash_ = false;
  individuals_.clear();
}

NodeId Assertions::add_node(NodeKind kind, NodeId parent, DependencySet dependency) {
  const NodeId id = graph_.add_node(kind, parent);
  if (program_.needs_thing()) add_fact(FactKind::concept_of, number(clauses::thing), id, 0, dependency);
  return id;
}

NodeId Assertions::constant(owl::TermId literal) {
  const owl::TermId chosen = values_.representative(literal);
  const auto [found, is_new] = constants_.try_emplace(chosen, none);
  const NodeId known = found->second;
  const bool is_there = known < graph_.node_count() && graph_.node(known).kind == NodeKind::constant &&
                        graph_.node(known).literal == static_cast<std::uint32_t>(chosen);
  if (is_there) return known;
  found->second = graph_.add_node(NodeKind::constant, none);
  graph_.set_literal(found->second, static_cast<std::uint32_t>(chosen));
  return found->second;
}

NodeId Assertions::introduced(NodeId node, std::uint32_t bound, std::uint32_t number) {
  for (const Introduced& one : introduced_) {
    if (one.node == node && one.bound == bound && one.number == number) return one.root;
  }
  const NodeId root = add_node(NodeKind::root, none, no_dependency);
  introduced_.push_back({node, bound, number, root});
  return root;
}

void Assertions::add_fact(FactKind kind, std::uint32_t predicate, NodeId a, NodeId b, DependencySet dependency) {
  if (kind == FactKind::concept_of && predicate == number(clauses::nothing)) {
    clash(dependency);
    return;
  }
  if (graph_.find(kind, predicate, a, b) != none) return;
  graph_.add({kind, predicate, a, b, dependency});
  effort_.count_step();
  have_values_changed_ = have_values_changed_ || kind == FactKind::data_role || kind == FactKind::data_range;
}

void Assertions::add_unequal(NodeId a, NodeId b, DependencySet dependency) {
  if (a == b) {
    clash(dependency);
    return;
  }
  if (graph_.are_siblings(a, b)) return;
  add_fact(FactKind::unequal, 0, std::min(a, b), std::max(a, b), dependency);
  if (graph_.node(a).kind == NodeKind::value || graph_.node(a).kind == NodeKind::constant) have_values_changed_ = true;
}

// Nodes of former questions may have the mark, too. With nominals it is another fact (begin_question()). Without them
// they are in kept models, in which nothing is derived any more, and on whose choices no later question depends: see
// Search::keep().
void Assertions::set_outside(std::vector<std::uint32_t> concepts) {
  base::sort_unique(concepts);
  if (outside_ == concepts) return;
  outside_ = std::move(concepts);
  is_below_outside_.resize(std::size_t{program_.mark_of_question()} + 1, false);
  for (const std::uint32_t id : below_outside_) is_below_outside_[id] = false;
  below_outside_.clear();
  const auto add = [this](std::uint32_t id) {
    if (!is_below_outside_[id]) below_outside_.push_back(id);
    is_below_outside_[id] = true;
  };
  std::ranges::for_each(outside_, add);
  for (std::size_t at = 0; at < below_outside_.size(); ++at)
    std::ranges::for_each(program_.told_below(below_outside_[at]), add);
}

FactId Assertions::find_mark(NodeId node) const {
  return graph_.find(FactKind::concept_of, program_.mark_of_question(), node, question_);
}

FactId Assertions::find_mark_against(std::uint32_t id, NodeId node) const {
  return outside_.empty() || !is_below_outside_[id] ? none : find_mark(node);
}

FactId Assertions::find_opposite(const Fact& fact) const {
  if (outside_.empty()) return none;
  if (std::ranges::binary_search(outside_, fact.predicate)) return find_mark(fact.a);
  FactId first = none;
  if (fact.predicate == program_.mark_of_question() && fact.b == question_) {
    for (const std::uint32_t id : outside_) first = std::min(first, graph_.find(FactKind::concept_of, id, fact.a));
  }
  return first;
}

bool Assertions::holds(const Choice& choice) {
  switch (choice.kind) {
    case ChoiceKind::concept_of:
      return choice.predicate == number(clauses::thing) ||
             graph_.find(FactKind::concept_of, choice.predicate, choice.a) != none;
    case ChoiceKind::role:
      return graph_.find(FactKind::role, choice.predicate, choice.a, choice.b) != none;
    case ChoiceKind::data_role:
      return graph_.find(FactKind::data_role, choice.predicate, choice.a, choice.b) != none;
    case ChoiceKind::equal:
      return choice.a == choice.b;
    case ChoiceKind::at_least:
      return graph_.find(FactKind::at_least, choice.predicate, choice.a) != none;
    case ChoiceKind::data_at_least:
      return graph_.find(FactKind::data_at_least, choice.predicate, choice.a) != none;
    case ChoiceKind::at_most:
      return program_.is_global(choice.predicate) || graph_.find(FactKind::at_most, choice.predicate, choice.a) != none;
    case ChoiceKind::data_range:
      return choice.predicate == 0 || graph_.find(FactKind::data_range, choice.predicate, choice.a) != none ||
             is_constant_in(choice.a, choice.predicate) == true;
    case ChoiceKind::introduce:
    case ChoiceKind::share_neighbours:
    case ChoiceKind::make_neighbours:
      return false;
  }
  return false;
}

bool Assertions::is_impossible(const Choice& choice) {
  if (choice.kind == ChoiceKind::concept_of) return choice.predicate == number(clauses::nothing);
  if (choice.kind != ChoiceKind::data_range) return false;
  return choice.predicate == 1 || is_constant_in(choice.a, choice.predicate) == false;
}

std::optional<bool> Assertions::is_constant_in(NodeId node, std::uint32_t range) {
  if (graph_.node(node).kind != NodeKind::constant) return std::nullopt;
  return values_.is_in(owl::TermId{graph_.node(node).literal}, range);
}

void Assertions::apply(Choice choice, DependencySet dependency) {
  choice.a = graph_.current(choice.a, dependency);
  choice.b = graph_.current(choice.b, dependency);
  if (!graph_.is_active(choice.a) || !graph_.is_active(choice.b)) return;
  switch (choice.kind) {
    case ChoiceKind::concept_of:
      if (choice.predicate != number(clauses::thing)) {
        add_fact(FactKind::concept_of, choice.predicate, choice.a, 0, dependency);
      }
      return;
    case ChoiceKind::role:
      add_fact(FactKind::role, choice.predicate, choice.a, choice.b, dependency);
      return;
    case ChoiceKind::data_role:
      add_fact(FactKind::data_role, choice.predicate, choice.a, choice.b, dependency);
      return;
    case ChoiceKind::equal:
      merges_.push_back({choice.a, choice.b, dependency});
      return;
    case ChoiceKind::at_least:
      add_fact(FactKind::at_least, choice.predicate, choice.a, 0, dependency);
      return;
    case ChoiceKind::data_at_least:
      add_fact(FactKind::data_at_least, choice.predicate, choice.a, 0, dependency);
      return;
    case ChoiceKind::at_most:
      add_fact(FactKind::at_most, choice.predicate, choice.a, 0, dependency);
      return;
    case ChoiceKind::data_range:
      if (is_impossible(choice)) {
        clash(dependency);
      } else if (!holds(choice)) {
        add_fact(FactKind::data_range, choice.predicate, choice.a, 0, dependency);
      }
      return;
    case ChoiceKind::introduce:
      merges_.push_back({choice.a, introduced(choice.b, choice.bound, choice.predicate), dependency});
      return;
    case ChoiceKind::share_neighbours:
    case ChoiceKind::make_neighbours:
      return;  // Expansion applies them
  }
}

void Assertions::add_individuals(std::size_t count, std::span<const clauses::IndividualId> apart) {
  individuals_.assign(count, none);
  const auto first = static_cast<NodeId>(graph_.node_count());
  for (const clauses::IndividualId individual : apart)
    individuals_[number(individual)] = add_node(NodeKind::root, none, no_dependency);
  if (!apart.empty()) add_siblings(first, no_dependency);
  for (NodeId& node : individuals_) {
    if (node == none) node = add_node(NodeKind::root, none, no_dependency);
  }
}

void Assertions::add_siblings(NodeId first, DependencySet dependency) {
  graph_.set_siblings(first, dependency);
  if (graph_.node(first).kind == NodeKind::value) have_values_changed_ = true;
}

void Assertions::merge_all() {
  // In the order in which they were added. Merging may add more.
  for (std::size_t at = 0; at < merges_.size() && !has_clash_; ++at) merge(Merge(merges_[at]));
  merges_.clear();
}

// Whether `node` stays and `other` goes. Roots stay, then nodes that are higher in the tree, then older nodes.
bool Assertions::is_kept(NodeId node, NodeId other) const {
  const auto rank = [this](NodeId id) {
    const Node& one = graph_.node(id);
    const bool is_fixed = one.kind == NodeKind::root || one.kind == NodeKind::constant;
    return std::tuple(!is_fixed, one.depth, id);
  };
  return rank(node) < rank(other);
}

void Assertions::merge(const Merge& merge) {
  DependencySet dependency = merge.dependency;
  NodeId to = graph_.current(merge.a, dependency);
  NodeId from = graph_.current(merge.b, dependency);
  if (to == from || !graph_.is_active(to) || !graph_.is_active(from)) return;
  if (!is_kept(to, from)) std::swap(to, from);
  if (const auto difference = graph_.difference(to, from)) {
    clash(unite(dependency, *difference));
    return;
  }
  if (graph_.node(to).kind == NodeKind::constant && graph_.node(from).kind == NodeKind::constant) {
    const owl::TermId first{graph_.node(to).literal};
    const owl::TermId second{graph_.node(from).literal};
    if (values_.are_different(first, second)) {
      clash(dependency);
      return;
    }
    effort_.set_reason("values whose equality is not known");
  }
  graph_.merge(from, to, dependency);
  copy_facts(from, to, dependency);
  keep_from_siblings(from, to, dependency);
  if (graph_.node(to).kind == NodeKind::constant || graph_.node(to).kind == NodeKind::value)
    have_values_changed_ = true;
}

// The node that stands for a sibling differs from the others.
void Assertions::keep_from_siblings(NodeId from, NodeId to, DependencySet dependency) {
  if (graph_.node(from).siblings == none) return;
  const Siblings siblings = graph_.siblings_of(from);
  const DependencySet both = unite(dependency, siblings.dependency);
  for (NodeId other = siblings.first; other < siblings.end; ++other) {
    if (other != from && graph_.is_active(other)) add_unequal(other, to, both);
  }
}

void Assertions::copy_facts(NodeId from, NodeId to, DependencySet dependency) {
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

std::string Assertions::check_values() {
  std::string unknown;
  if (graph_.values().empty()) return unknown;
  const bool has_all_facts = !has_individuals_ || !individuals_.empty();
  if (const auto dependency = values_.clash(graph_, unknown, has_all_facts)) clash(*dependency);
  constexpr std::size_t values_a_step = 4;
  constexpr std::size_t free_values_a_step = 64;
  effort_.count_steps(values_.take_looked() / values_a_step +
                      (graph_.values().size() - settled_values_) / free_values_a_step);
  return unknown;
}

}  // namespace geminga::hypertableau
