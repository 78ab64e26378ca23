// Clauses and facts.
//
//   Hyp-rule:  B1, ..., Bm -> H1 or ... or Hn, and facts that match the body: one of the heads holds. With no head the
//   branch is closed, with one it is a fact, with more it is a choice.
#include <algorithm>

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::number;

NodeId Tableau::Search::add_node(NodeKind kind, NodeId parent, DependencySet dependency) {
  const NodeId id = graph_.add_node(kind, parent);
  if (program_.needs_thing()) add_fact(FactKind::concept_of, number(clauses::thing), id, 0, dependency);
  return id;
}

void Tableau::Search::add_fact(FactKind kind, std::uint32_t predicate, NodeId a, NodeId b, DependencySet dependency) {
  if (kind == FactKind::concept_of && predicate == number(clauses::nothing)) {
    clash(dependency);
    return;
  }
  if (graph_.find(kind, predicate, a, b) != none) return;
  graph_.add({kind, predicate, a, b, dependency});
  ++steps_;
  values_changed_ = values_changed_ || kind == FactKind::data_role || kind == FactKind::data_range;
}

void Tableau::Search::add_unequal(NodeId a, NodeId b, DependencySet dependency) {
  if (a == b) {
    clash(dependency);
    return;
  }
  add_fact(FactKind::unequal, 0, std::min(a, b), std::max(a, b), dependency);
  if (graph_.node(a).kind == NodeKind::value || graph_.node(a).kind == NodeKind::constant) values_changed_ = true;
}

void Tableau::Search::process(FactId id) {
  const Fact fact = graph_.fact(id);
  if (!graph_.is_active(fact.a)) return;
  switch (fact.kind) {
    case FactKind::concept_of:
      process_concept(fact, id);
      return;
    case FactKind::role:
    case FactKind::data_role: {
      if (!graph_.is_active(fact.b)) return;
      const bool is_data = fact.kind == FactKind::data_role;
      for (const Plan& plan : is_data ? program_.of_data_role(fact.predicate) : program_.of_role(fact.predicate)) {
        fire(plan, id);
        if (has_clash_) return;
      }
      suspect_role(fact.predicate, fact.a, fact.b, is_data);
      if (is_data) {
        keep_apart(fact);
      } else if (fact.a == fact.b) {
        suspect_loop(fact.predicate, fact.a);
      }
      return;
    }
    case FactKind::at_least:
    case FactKind::data_at_least: {
      note_existential(fact, id);
      const bool is_data = fact.kind == FactKind::data_at_least;
      for (const std::uint32_t of : is_data ? program_.domains().of_data_at_least(fact.predicate)
                                            : program_.domains().of_at_least(fact.predicate)) {
        add_fact(FactKind::concept_of, of, fact.a, 0, fact.dependency);
      }
      return;
    }
    case FactKind::at_most:
      suspect(fact.a, fact.predicate);
      return;
    default:
      return;
  }
}

/// U(x,v), V(x,w) -> v != w  where U and V are disjoint
void Tableau::Search::keep_apart(const Fact& fact) {
  for (const std::uint32_t other : program_.disjoint_with(fact.predicate)) {
    for (FactId id = graph_.node(fact.a).out; id != none && !has_clash_; id = graph_.fact(id).next_a) {
      const Fact edge = graph_.fact(id);
      if (edge.kind != FactKind::data_role || edge.predicate != other || !graph_.is_active(edge.b)) continue;
      add_unequal(fact.b, edge.b, unite(fact.dependency, edge.dependency));
    }
  }
}

void Tableau::Search::process_concept(const Fact& fact, FactId id) {
  const bool is_nominal =
      fact.predicate < set_.concepts.size() && set_.concepts[fact.predicate].kind == clauses::ConceptKind::nominal;
  if (is_nominal) {
    // {a}(x) -> x = a
    DependencySet dependency = fact.dependency;
    const clauses::IndividualId individual = set_.concepts[fact.predicate].individual;
    const NodeId node = graph_.current(individuals_[number(individual)], sets_, dependency);
    if (node != fact.a) merges_.push_back({fact.a, node, dependency});
  }
  for (const Plan& plan : program_.of_concept(fact.predicate)) {
    fire(plan, id);
    if (has_clash_) return;
  }
  suspect_filler(fact.predicate, fact.a);
  for (const std::uint32_t bound : program_.bounds_of_guard(fact.predicate)) suspect(fact.a, bound);
}

void Tableau::Search::fire(const Plan& plan, FactId id) {
  const Fact& fact = graph_.fact(id);
  variables_[plan.first] = fact.a;
  if (fact.kind != FactKind::concept_of) {
    if (plan.first == plan.second && fact.a != fact.b) return;
    variables_[plan.second] = fact.b;
  }
  match(plan, program_.steps(plan), id, fact.dependency);
}

void Tableau::Search::match(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency) {
  // Facts that came after the trigger wait for their own turn.
  while (!steps.empty()) {
    count_look();
    const Step& step = steps.front();
    FactId found = none;
    if (step.kind == StepKind::check_concept) {
      found = graph_.find(FactKind::concept_of, step.predicate, variables_[step.first]);
    } else if (step.kind == StepKind::check_role) {
      found = graph_.find(FactKind::role, step.predicate, variables_[step.first], variables_[step.second]);
    } else if (step.kind == StepKind::check_data) {
      found = graph_.find(FactKind::data_role, step.predicate, variables_[step.first], variables_[step.second]);
    } else {
      match_each(plan, steps, limit, dependency);
      return;
    }
    if (found == none || found > limit) return;
    dependency = unite(dependency, graph_.fact(found).dependency);
    steps = steps.subspan(1);
  }
  conclude(plan, dependency);
}

void Tableau::Search::match_each(const Plan& plan, std::span<const Step> steps, FactId limit,
                                 DependencySet dependency) {
  const Step step = steps.front();
  const bool is_forward = step.kind == StepKind::each_out || step.kind == StepKind::each_value;
  const bool is_data = step.kind == StepKind::each_value || step.kind == StepKind::each_subject;
  const FactKind kind = is_data ? FactKind::data_role : FactKind::role;
  const NodeId from = variables_[is_forward ? step.first : step.second];
  for (FactId id = is_forward ? graph_.node(from).out : graph_.node(from).in; id != none;
       id = is_forward ? graph_.fact(id).next_a : graph_.fact(id).next_b) {
    const Fact& fact = graph_.fact(id);
    count_look();
    const NodeId to = is_forward ? fact.b : fact.a;
    if (id > limit || fact.kind != kind || fact.predicate != step.predicate || !graph_.is_active(to)) continue;
    variables_[is_forward ? step.second : step.first] = to;
    match(plan, steps.subspan(1), limit, unite(dependency, fact.dependency));
    if (has_clash_ || is_over_limit()) return;
  }
}

Choice Tableau::Search::choice_of(const Atom& atom, NodeId a, NodeId b) const {
  switch (atom.kind) {
    case AtomKind::concept_of:
      return {ChoiceKind::concept_of, atom.predicate, a, a};
    case AtomKind::role:
      return {ChoiceKind::role, atom.predicate, a, b};
    case AtomKind::data_range:
      return {ChoiceKind::data_range, atom.predicate, a, a};
    case AtomKind::at_least:
      return {ChoiceKind::at_least, atom.predicate, a, a};
    case AtomKind::data_at_least:
      return {ChoiceKind::data_at_least, atom.predicate, a, a};
    case AtomKind::at_most:
    case AtomKind::data_at_most:
      return {ChoiceKind::at_most, program_.bound_of_atom(atom), a, a};
    case AtomKind::data_role:
      return {ChoiceKind::data_role, atom.predicate, a, b};
    case AtomKind::equal:
    case AtomKind::data_equal:
      break;
  }
  return {ChoiceKind::equal, 0, a, b};
}

void Tableau::Search::conclude(const Plan& plan, DependencySet dependency) {
  const auto head = program_.head(plan);
  if (head.empty()) {
    clash(dependency);
    return;
  }
  if (head.size() == 1) {
    apply(choice_of(head[0], variables_[head[0].first], variables_[head[0].second]), dependency);
    return;
  }
  std::vector<Choice> alternatives;
  for (const Atom& atom : head) {
    const Choice choice = choice_of(atom, variables_[atom.first], variables_[atom.second]);
    if (holds(choice)) return;
    alternatives.push_back(choice);
  }
  add_disjunction(alternatives, dependency);
}

void Tableau::Search::add_disjunction(std::vector<Choice>& alternatives, DependencySet dependency) {
  std::erase_if(alternatives, [this](const Choice& choice) { return is_impossible(choice); });
  if (alternatives.empty()) {
    clash(dependency);
  } else if (alternatives.size() == 1) {
    apply(alternatives.front(), dependency);
  } else {
    const auto begin = static_cast<std::uint32_t>(choices_.size());
    ++steps_;
    choices_.insert(choices_.end(), alternatives.begin(), alternatives.end());
    disjunctions_.push_back({begin, static_cast<std::uint32_t>(choices_.size()), dependency});
  }
}

bool Tableau::Search::holds(const Choice& choice) {
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
      return false;
  }
  return false;
}

bool Tableau::Search::is_impossible(const Choice& choice) {
  if (choice.kind == ChoiceKind::concept_of) return choice.predicate == number(clauses::nothing);
  if (choice.kind != ChoiceKind::data_range) return false;
  return choice.predicate == 1 || is_constant_in(choice.a, choice.predicate) == false;
}

std::optional<bool> Tableau::Search::is_constant_in(NodeId node, std::uint32_t range) {
  if (graph_.node(node).kind != NodeKind::constant) return std::nullopt;
  return values_.is_in(owl::TermId{graph_.node(node).literal}, range);
}

void Tableau::Search::apply(Choice choice, DependencySet dependency) {
  choice.a = graph_.current(choice.a, sets_, dependency);
  choice.b = graph_.current(choice.b, sets_, dependency);
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
  }
}

}  // namespace geminga::hypertableau
