// How clauses are matched. The rule is in clause_matches.hpp.
#include "reasoning/dl/hypertableau/clause_matches.hpp"

namespace geminga::hypertableau {

using clauses::Atom;

ClauseMatches::ClauseMatches(const Program& program, const Graph& graph, Effort& effort, Assertions& facts,
                             Disjunctions& disjunctions)
    : program_(program), graph_(graph), effort_(effort), facts_(facts), disjunctions_(disjunctions) {
  variables_.assign(256, 0);
}

bool ClauseMatches::add_heads(std::span<const Plan> plans, FactId trigger) {
  for (const Plan& plan : plans) {
    fire(plan, trigger);
    if (facts_.has_clash()) return false;
  }
  return true;
}

void ClauseMatches::fire(const Plan& plan, FactId id) {
  const Fact& fact = graph_.fact(id);
  variables_[plan.first] = fact.a;
  if (fact.kind != FactKind::concept_of) {
    if (plan.first == plan.second && fact.a != fact.b) return;
    variables_[plan.second] = fact.b;
  }
  match(plan, program_.steps(plan), id, fact.dependency);
}

void ClauseMatches::match(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency) {
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
    dependency = graph_.unite(dependency, graph_.fact(found).dependency);
    steps = steps.subspan(1);
  }
  conclude(plan, dependency);
}

void ClauseMatches::match_each(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency) {
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
    match(plan, steps.subspan(1), limit, graph_.unite(dependency, fact.dependency));
    if (facts_.must_stop()) return;
  }
}

void ClauseMatches::conclude(const Plan& plan, DependencySet dependency) {
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
