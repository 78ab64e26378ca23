// Which disjunction is next: one that has no way left is a clash, one that has one way left is no choice, and of the
// others that with the fewest ways. And which way of it is tried first.
#include <algorithm>

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {

using clauses::number;

namespace {

/// As many open disjunctions are compared before one is taken: few as long as every guess was right, as in most models.
constexpr std::size_t few_compared = 16;
constexpr std::size_t max_compared = 256;

/// What a choice brings with it: a bound that holds brings nothing, new nodes bring much, and what is made equal is
/// seldom meant to be.
int burden(ChoiceKind kind) {
  switch (kind) {
    case ChoiceKind::at_most:
      return 0;
    case ChoiceKind::concept_of:
    case ChoiceKind::role:
    case ChoiceKind::data_role:
    case ChoiceKind::data_range:
      return 1;
    case ChoiceKind::at_least:
    case ChoiceKind::data_at_least:
      return 2;
    case ChoiceKind::equal:
    case ChoiceKind::introduce:
      return 3;
  }
  return 3;
}

}  // namespace

/// Whether something was done: a branch, a fact without alternatives, or a clash.
bool Tableau::Search::choose() {
  Open& one = open_;
  Open& best = best_open_;
  const std::size_t most = has_failed_ ? max_compared : few_compared;
  std::size_t compared = 0;
  for (std::size_t at = next_disjunction_; at < disjunctions_.size() && compared < most; ++at) {
    if (!disjunctions_[at].is_done) {
      open(disjunctions_[at], one);
      if (one.is_done) note_done(at);
    }
    if (disjunctions_[at].is_done) {
      if (at == next_disjunction_) ++next_disjunction_;
      continue;
    }
    if (one.alternatives.empty()) {
      clash(one.dependency);
      return true;
    }
    if (one.alternatives.size() == 1) {
      apply(one.alternatives.front(), one.dependency);
      return true;
    }
    one.failures = has_failed_ ? failures_of(one.alternatives) : 0;
    if (compared++ == 0 || one.is_before(best)) std::swap(one, best);
  }
  if (compared == 0) return choose_for_bound();
  branch(best.alternatives, best.dependency, {none, none});
  return true;
}

/// What holds goes on holding as long as this branch is.
void Tableau::Search::note_done(std::size_t disjunction) {
  disjunctions_[disjunction].is_done = true;
  done_disjunctions_.push_back(static_cast<std::uint32_t>(disjunction));
}

/// By the share of the tries that failed as Laplace estimates it, so that one failure among many successes does not
/// turn the choice for all nodes; then by what they bring.
void Tableau::Search::order_by_promise(std::vector<Choice>& alternatives) {
  std::ranges::stable_sort(alternatives, [this](const Choice& one, const Choice& other) {
    const Record first = record_of(one);
    const Record second = record_of(other);
    const std::uint64_t risk = (first.failures + 1) * (second.tries + 2);
    const std::uint64_t other_risk = (second.failures + 1) * (first.tries + 2);
    return risk != other_risk ? risk < other_risk : burden(one.kind) < burden(other.kind);
  });
}

/// The fewest ways for each failure that is known of them: one that fails in all of many ways says what is wrong sooner
/// than many that have two (dom/wdeg: Boussemart, Hemery, Lecoutre, Sais: Boosting systematic search by weighting
/// constraints, 2004).
bool Tableau::Search::Open::is_before(const Open& other) const {
  return alternatives.size() * (1 + other.failures) < other.alternatives.size() * (1 + failures);
}

std::uint64_t Tableau::Search::failures_of(std::span<const Choice> alternatives) {
  std::uint64_t failures = 0;
  for (const Choice& choice : alternatives) {
    failures += record_of(choice).failures;
  }
  return failures;
}

bool Tableau::Search::choose_for_bound() {
  while (next_demand_ < demands_.size()) {
    DependencySet dependency = no_dependency;
    Suspect suspect = demands_[next_demand_++];
    suspect.node = graph_.current(suspect.node, sets_, dependency);
    if (!graph_.is_active(suspect.node)) continue;
    enforce(suspect, dependency);
    if (has_clash_ || !merges_.empty() || processed_ < graph_.facts().size()) return true;
  }
  return false;
}

void Tableau::Search::open(const Disjunction& disjunction, Open& result) {
  result.alternatives.clear();
  result.dependency = disjunction.dependency;
  for (std::uint32_t at = disjunction.begin; at < disjunction.end; ++at) {
    count_look();
    Choice choice = choices_[at];
    choice.a = graph_.current(choice.a, sets_, result.dependency);
    choice.b = graph_.current(choice.b, sets_, result.dependency);
    result.is_done = !graph_.is_active(choice.a) || !graph_.is_active(choice.b) || holds(choice) || derive(choice);
    if (result.is_done) return;
    if (!is_excluded(choice, result.dependency)) result.alternatives.push_back(choice);
  }
}

bool Tableau::Search::is_excluded(const Choice& choice, DependencySet& dependency) {
  if (is_impossible(choice)) return true;
  if (choice.kind == ChoiceKind::equal) {
    const auto [a, b] = std::minmax(choice.a, choice.b);
    const FactId differ = graph_.find(FactKind::unequal, 0, a, b);
    if (differ != none) dependency = unite(dependency, graph_.fact(differ).dependency);
    return differ != none;
  }
  if (choice.kind == ChoiceKind::concept_of) return is_excluded(choice.predicate, choice.a, dependency);
  if (choice.kind == ChoiceKind::at_most)
    return exceeds(program_.bound(choice.predicate), counted({choice.a, choice.predicate}), dependency);
  const bool is_data = choice.kind == ChoiceKind::data_at_least;
  if (choice.kind != ChoiceKind::at_least && !is_data) return false;
  const auto implied = is_data ? program_.domains().of_data_at_least(choice.predicate)
                               : program_.domains().of_at_least(choice.predicate);
  if (std::ranges::any_of(implied, [&](std::uint32_t of) { return is_excluded(of, choice.a, dependency); }))
    return true;
  return !is_data && is_excluded_by_neighbour(choice, dependency);
}

/// Where a property has at most one value, the neighbour that is there would have to be in the filler.
bool Tableau::Search::is_excluded_by_neighbour(const Choice& choice, DependencySet& dependency) {
  const clauses::AtLeast& at_least = set_.at_leasts[choice.predicate];
  const auto neighbour = only_neighbour(at_least.role, choice.a);
  DependencySet reasons = neighbour ? neighbour->dependency : no_dependency;
  if (!neighbour || !is_excluded(number(at_least.filler), neighbour->node, reasons)) return false;
  dependency = unite(dependency, reasons);
  return true;
}

/// Derives what a choice says where it follows from what is there: an at-least that a neighbour satisfies.
bool Tableau::Search::derive(const Choice& choice) {
  if (choice.kind != ChoiceKind::at_least || set_.at_leasts[choice.predicate].count > 1) return false;
  const clauses::AtLeast& at_least = set_.at_leasts[choice.predicate];
  const bool is_inverse = at_least.role.is_inverse;
  for (FactId id = is_inverse ? graph_.node(choice.a).in : graph_.node(choice.a).out; id != none;
       id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    count_look();
    const Fact& edge = graph_.fact(id);
    const NodeId node = is_inverse ? edge.a : edge.b;
    if (edge.kind != FactKind::role || edge.predicate != number(at_least.role.property) || !graph_.is_active(node))
      continue;
    DependencySet dependency = edge.dependency;
    if (at_least.filler != clauses::thing) {
      const FactId filler = graph_.find(FactKind::concept_of, number(at_least.filler), node);
      if (filler == none) continue;
      dependency = unite(dependency, graph_.fact(filler).dependency);
    }
    add_fact(FactKind::at_least, choice.predicate, choice.a, 0, dependency);
    return true;
  }
  return false;
}

/// Whether a bound that the concept brings is exceeded already.
bool Tableau::Search::is_excluded_by_bound(std::uint32_t id, NodeId node, DependencySet& dependency) {
  const auto is_brought = [id](const ConditionalBound& rule) {
    return rule.alternatives.empty() && rule.guard.size() == 1 &&
           rule.guard.front().kind == clauses::AtomKind::concept_of && rule.guard.front().predicate == id;
  };
  return std::ranges::any_of(program_.bounds_of_guard(id), [&](std::uint32_t bound) {
    return std::ranges::any_of(program_.conditional(bound), is_brought) &&
           exceeds(program_.bound(bound), counted({node, bound}), dependency);
  });
}

bool Tableau::Search::is_excluded(std::uint32_t id, NodeId node, DependencySet& dependency) {
  if (is_excluded_by_bound(id, node, dependency)) return true;
  const auto excluders = program_.disjoint_concepts(id);
  if (excluders.size() <= graph_.node(node).label_count) {
    for (const std::uint32_t other : excluders) {
      const FactId fact = graph_.find(FactKind::concept_of, other, node);
      if (fact == none) continue;
      dependency = unite(dependency, graph_.fact(fact).dependency);
      return true;
    }
    return false;
  }
  for (FactId fact = graph_.node(node).labels; fact != none; fact = graph_.fact(fact).next_a) {
    if (!std::ranges::binary_search(excluders, graph_.fact(fact).predicate)) continue;
    dependency = unite(dependency, graph_.fact(fact).dependency);
    return true;
  }
  return false;
}

}  // namespace geminga::hypertableau
