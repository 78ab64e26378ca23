// Reasons for which the facts exclude an alternative.
#include "reasoning/dl/hypertableau/facts/choice_check.hpp"

#include <algorithm>

namespace geminga::hypertableau {

using clauses::number;

bool ChoiceCheck::is_excluded(const Choice& choice, DependencySet& dependency) {
  if (facts_.is_impossible(choice) || numbers_.excludes(choice, dependency)) return true;
  if (choice.kind == ChoiceKind::equal) {
    const auto difference = graph_.difference(choice.a, choice.b);
    if (difference) dependency = graph_.unite(dependency, *difference);
    return difference.has_value();
  }
  if (choice.kind == ChoiceKind::concept_of) return is_excluded(choice.predicate, choice.a, dependency);
  if (choice.kind == ChoiceKind::at_most)
    return neighbours_.exceeds(program_.bound(choice.predicate), neighbours_.counted({choice.a, choice.predicate}),
                               dependency);
  const bool is_data = choice.kind == ChoiceKind::data_at_least;
  if (choice.kind != ChoiceKind::at_least && !is_data) return false;
  const auto implied = is_data ? program_.domains().of_data_at_least(choice.predicate)
                               : program_.domains().of_at_least(choice.predicate);
  if (std::ranges::any_of(implied, [&](std::uint32_t of) { return is_excluded(of, choice.a, dependency); }))
    return true;
  return !is_data && is_excluded_by_neighbour(choice, dependency);
}

// If the property has at most one value, the neighbour in the graph would have to be in the filler.
bool ChoiceCheck::is_excluded_by_neighbour(const Choice& choice, DependencySet& dependency) {
  const clauses::AtLeast& at_least = program_.at_least(choice.predicate);
  const auto neighbour = neighbours_.only(at_least.role, choice.a);
  DependencySet reasons = neighbour ? neighbour->dependency : no_dependency;
  if (!neighbour || !is_excluded(number(at_least.filler), neighbour->node, reasons)) return false;
  dependency = graph_.unite(dependency, reasons);
  return true;
}

// Whether a bound that the concept implies is exceeded by neighbours, or by what at-leasts ask for.
bool ChoiceCheck::is_excluded_by_bound(std::uint32_t id, NodeId node, DependencySet& dependency) {
  return std::ranges::any_of(program_.bounds_of_guard(id), [&](std::uint32_t bound) {
    return program_.brings(id, bound) &&
           (numbers_.excludes({ChoiceKind::at_most, bound, node, node}, dependency) ||
            neighbours_.exceeds(program_.bound(bound), neighbours_.counted({node, bound}), dependency));
  });
}

bool ChoiceCheck::is_excluded(std::uint32_t id, NodeId node, DependencySet& dependency) {
  if (is_excluded_by_bound(id, node, dependency)) return true;
  if (const FactId mark = facts_.find_mark_against(id, node); mark != none) {
    dependency = graph_.unite(dependency, graph_.fact(mark).dependency);
    return true;
  }
  const FactId fact = neighbours_.find_excluder(id, node);
  if (fact != none) dependency = graph_.unite(dependency, graph_.fact(fact).dependency);
  return fact != none;
}

}  // namespace geminga::hypertableau
