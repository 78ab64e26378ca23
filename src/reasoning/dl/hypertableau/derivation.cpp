// How facts are processed and clauses matched. The rule is in derivation.hpp.
#include "reasoning/dl/hypertableau/derivation.hpp"

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::number;

Derivation::Derivation(const clauses::ClauseSet& set, const Program& program, const Graph& graph, DependencySets& sets,
                       Effort& effort, Assertions& facts, const Numbers& numbers, Disjunctions& disjunctions,
                       Bounds& bounds, Expansion& expansion)
    : set_(set),
      program_(program),
      graph_(graph),
      sets_(sets),
      effort_(effort),
      facts_(facts),
      numbers_(numbers),
      disjunctions_(disjunctions),
      bounds_(bounds),
      expansion_(expansion) {
  variables_.assign(256, 0);
}

void Derivation::process(FactId id) {
  const Fact fact = graph_.fact(id);
  if (!graph_.is_active(fact.a)) return;
  switch (fact.kind) {
    case FactKind::concept_of:
      process_concept(fact, id);
      return;
    case FactKind::role:
    case FactKind::data_role:
      process_role(fact, id);
      return;
    case FactKind::at_least:
    case FactKind::data_at_least:
      process_at_least(fact, id);
      return;
    case FactKind::at_most:
      if (contradicts({ChoiceKind::at_most, fact.predicate, fact.a, fact.a}, fact.dependency)) return;
      bounds_.note({fact.a, fact.predicate});
      return;
    default:
      return;
  }
}

void Derivation::process_role(const Fact& fact, FactId id) {
  if (!graph_.is_active(fact.b)) return;
  const bool is_data = fact.kind == FactKind::data_role;
  for (const Plan& plan : is_data ? program_.of_data_role(fact.predicate) : program_.of_role(fact.predicate)) {
    fire(plan, id);
    if (facts_.has_clash()) return;
  }
  bounds_.note_role(fact.predicate, fact.a, fact.b, is_data);
  if (is_data) {
    keep_apart(fact);
  } else if (fact.a == fact.b) {
    bounds_.note_loop(fact.predicate, fact.a);
  }
}

/// Clashes if another number restriction of the node excludes this one.
bool Derivation::contradicts(const Choice& choice, DependencySet dependency) {
  if (!numbers_.excludes(choice, dependency)) return false;
  facts_.clash(dependency);
  return true;
}

void Derivation::process_at_least(const Fact& fact, FactId id) {
  const bool is_data = fact.kind == FactKind::data_at_least;
  const ChoiceKind kind = is_data ? ChoiceKind::data_at_least : ChoiceKind::at_least;
  if (contradicts({kind, fact.predicate, fact.a, fact.a}, fact.dependency)) return;
  expansion_.add(fact, id);
  for (const std::uint32_t of :
       is_data ? program_.domains().of_data_at_least(fact.predicate) : program_.domains().of_at_least(fact.predicate)) {
    facts_.add_fact(FactKind::concept_of, of, fact.a, 0, fact.dependency);
  }
}

/// U(x,v), V(x,w) -> v != w  where U and V are disjoint
void Derivation::keep_apart(const Fact& fact) {
  for (const std::uint32_t other : program_.disjoint_with(fact.predicate)) {
    for (FactId id = graph_.node(fact.a).out; id != none && !facts_.has_clash(); id = graph_.fact(id).next_a) {
      const Fact edge = graph_.fact(id);
      if (edge.kind != FactKind::data_role || edge.predicate != other || !graph_.is_active(edge.b)) continue;
      facts_.add_unequal(fact.b, edge.b, unite(fact.dependency, edge.dependency));
    }
  }
}

void Derivation::process_concept(const Fact& fact, FactId id) {
  const bool is_nominal =
      fact.predicate < set_.concepts.size() && set_.concepts[fact.predicate].kind == clauses::ConceptKind::nominal;
  if (is_nominal) {
    // {a}(x) -> x = a
    DependencySet dependency = fact.dependency;
    const clauses::IndividualId individual = set_.concepts[fact.predicate].individual;
    const NodeId node = graph_.current(facts_.individuals()[number(individual)], sets_, dependency);
    if (node != fact.a) facts_.add_merge(fact.a, node, dependency);
  }
  // The mark and the concept that it excludes. Facts that came later wait for their own turn.
  if (const FactId opposite = facts_.find_opposite(fact.predicate, fact.a); opposite < id) {
    facts_.clash(unite(fact.dependency, graph_.fact(opposite).dependency));
    return;
  }
  for (const Plan& plan : program_.of_concept(fact.predicate)) {
    fire(plan, id);
    if (facts_.has_clash()) return;
  }
  bounds_.note_concept(fact.predicate, fact.a);
  for (const std::uint32_t bound : program_.bounds_of_guard(fact.predicate)) {
    DependencySet reasons = no_dependency;
    if (numbers_.is_exceeded(bound, fact.a, reasons)) return facts_.clash(reasons);
  }
}

void Derivation::fire(const Plan& plan, FactId id) {
  const Fact& fact = graph_.fact(id);
  variables_[plan.first] = fact.a;
  if (fact.kind != FactKind::concept_of) {
    if (plan.first == plan.second && fact.a != fact.b) return;
    variables_[plan.second] = fact.b;
  }
  match(plan, program_.steps(plan), id, fact.dependency);
}

void Derivation::match(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency) {
  // Facts that came after the trigger wait for their own turn.
  while (!steps.empty()) {
    effort_.count_look();
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

void Derivation::match_each(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency) {
  const Step step = steps.front();
  const bool is_forward = step.kind == StepKind::each_out || step.kind == StepKind::each_value;
  const bool is_data = step.kind == StepKind::each_value || step.kind == StepKind::each_subject;
  const FactKind kind = is_data ? FactKind::data_role : FactKind::role;
  const NodeId from = variables_[is_forward ? step.first : step.second];
  for (FactId id = is_forward ? graph_.node(from).out : graph_.node(from).in; id != none;
       id = is_forward ? graph_.fact(id).next_a : graph_.fact(id).next_b) {
    const Fact& fact = graph_.fact(id);
    effort_.count_look();
    const NodeId to = is_forward ? fact.b : fact.a;
    if (id > limit || fact.kind != kind || fact.predicate != step.predicate || !graph_.is_active(to)) continue;
    variables_[is_forward ? step.second : step.first] = to;
    match(plan, steps.subspan(1), limit, unite(dependency, fact.dependency));
    if (facts_.has_clash() || effort_.is_over_limit()) return;
  }
}

void Derivation::conclude(const Plan& plan, DependencySet dependency) {
  const auto head = program_.head(plan);
  if (head.empty()) {
    facts_.clash(dependency);
    return;
  }
  if (head.size() == 1) {
    facts_.apply(choice_of(program_, head[0], variables_[head[0].first], variables_[head[0].second]), dependency);
    return;
  }
  std::vector<Choice> alternatives;
  for (const Atom& atom : head) {
    const Choice choice = choice_of(program_, atom, variables_[atom.first], variables_[atom.second]);
    if (facts_.holds(choice)) return;
    alternatives.push_back(choice);
  }
  disjunctions_.add(alternatives, dependency);
}

}  // namespace geminga::hypertableau
