// The restrictions of a node are looked through one by one.
#include "reasoning/dl/hypertableau/facts/numbers.hpp"

#include <algorithm>
#include <functional>
#include <vector>

namespace geminga::hypertableau {

namespace {

/// Bounds that are looked up in the time of a look at a fact.
constexpr std::uint32_t bounds_a_look = 8;

bool is_at_least(const Choice& choice) {
  return choice.kind == ChoiceKind::at_least || choice.kind == ChoiceKind::data_at_least;
}

bool is_at_least(const Fact& fact) { return fact.kind == FactKind::at_least || fact.kind == FactKind::data_at_least; }

NumberOrder::AtLeastId id_of(const Choice& choice) {
  return {choice.predicate, choice.kind == ChoiceKind::data_at_least};
}

NumberOrder::AtLeastId id_of(const Fact& fact) { return {fact.predicate, fact.kind == FactKind::data_at_least}; }

}  // namespace

bool Numbers::is_in_force(std::uint32_t bound, NodeId node, DependencySet& dependency) const {
  if (++bounds_looked_at_ % bounds_a_look == 0) effort_.count_look();
  if (program_.is_global(bound)) return true;
  if (const FactId fact = graph_.find(FactKind::at_most, bound, node); fact != none) {
    dependency = graph_.unite(dependency, graph_.fact(fact).dependency);
    return true;
  }
  return std::ranges::any_of(program_.conditional(bound), [&](const ConditionalBound& rule) {
    if (!rule.alternatives.empty()) return false;
    DependencySet reasons = dependency;
    for (const clauses::Atom& atom : rule.guard) {
      const bool is_role = atom.kind == clauses::AtomKind::role;
      const FactId fact = is_role ? graph_.find(FactKind::role, atom.predicate, node, node)
                                  : graph_.find(FactKind::concept_of, atom.predicate, node);
      if (fact == none) return false;
      reasons = graph_.unite(reasons, graph_.fact(fact).dependency);
    }
    dependency = reasons;
    return true;
  });
}

bool Numbers::implies(const Choice& choice) const {
  const bool is_at_most = choice.kind == ChoiceKind::at_most;
  if (!program_.counts() || (!is_at_most && !is_at_least(choice))) return false;
  const NumberOrder& numbers = program_.numbers();
  if (is_at_most) {
    DependencySet ignored = no_dependency;
    return numbers.may_be_implied(choice.predicate) && numbers.any_implying(choice.predicate, [&](std::uint32_t bound) {
      return bound != choice.predicate && is_in_force(bound, choice.a, ignored);
    });
  }
  if (!numbers.may_be_implied(id_of(choice))) return false;
  for (FactId id = graph_.node(choice.a).others; id != none; id = graph_.next_other(id, choice.a)) {
    effort_.count_look();
    const Fact& fact = graph_.fact(id);
    if (is_at_least(fact) && numbers.implies(id_of(fact), id_of(choice))) return true;
  }
  return false;
}

bool Numbers::excludes(const Choice& choice, DependencySet& dependency) const {
  const bool is_at_most = choice.kind == ChoiceKind::at_most;
  if (!program_.counts() || (!is_at_most && !is_at_least(choice))) return false;
  const NumberOrder& numbers = program_.numbers();
  if (!is_at_most) {
    const bool is_excluded =
        numbers.may_be_excluded(id_of(choice)) && numbers.any_excluding(id_of(choice), [&](std::uint32_t bound) {
          return is_in_force(bound, choice.a, dependency);
        });
    return is_excluded || are_too_many(choice, dependency) || are_covered(choice, dependency);
  }
  if (!numbers.may_be_excluded(choice.predicate))
    return are_too_many(choice, dependency) || are_covered(choice, dependency);
  for (FactId id = graph_.node(choice.a).others; id != none; id = graph_.next_other(id, choice.a)) {
    effort_.count_look();
    const Fact& fact = graph_.fact(id);
    if (!is_at_least(fact) || !numbers.excludes(id_of(fact), choice.predicate)) continue;
    dependency = graph_.unite(dependency, fact.dependency);
    return true;
  }
  return are_too_many(choice, dependency) || are_covered(choice, dependency);
}

bool Numbers::is_exceeded(std::uint32_t bound, NodeId node, DependencySet& dependency) const {
  if (!program_.counts()) return false;
  const NumberOrder& numbers = program_.numbers();
  if (!numbers.may_be_excluded(bound) && !numbers.may_be_added(bound) && !program_.covers().is_any_of(bound))
    return false;
  DependencySet reasons = dependency;
  if (!is_in_force(bound, node, reasons) || !excludes({ChoiceKind::at_most, bound, node, node}, reasons)) return false;
  dependency = reasons;
  return true;
}

// Whether at-leasts of the node, with the choice, exceed a bound together. The neighbours of those whose fillers
// exclude each other add up.
bool Numbers::are_too_many(const Choice& choice, DependencySet& dependency) const {
  const NumberOrder& numbers = program_.numbers();
  if (choice.kind == ChoiceKind::at_most)
    return numbers.may_be_added(choice.predicate) && are_too_many(choice.predicate, choice, dependency);
  return numbers.may_be_added(id_of(choice)) && numbers.any_adding(id_of(choice), [&](std::uint32_t bound) {
    DependencySet reasons = dependency;
    if (!is_in_force(bound, choice.a, reasons) || !are_too_many(bound, choice, reasons)) return false;
    dependency = reasons;
    return true;
  });
}

bool Numbers::are_too_many(std::uint32_t bound, const Choice& choice, DependencySet& dependency) const {
  struct Asked {
    std::uint32_t count = 0;
    NumberOrder::AtLeastId id;
    DependencySet dependency = no_dependency;
  };
  const NumberOrder& numbers = program_.numbers();
  std::vector<Asked> asked;
  std::uint64_t all = 0;
  const auto add = [&](NumberOrder::AtLeastId id, DependencySet reasons) {
    if (!numbers.may_be_added(id) || !numbers.counts(bound, id)) return;
    asked.push_back({numbers.count(id), id, reasons});
    all += asked.back().count;
  };
  if (is_at_least(choice)) add(id_of(choice), no_dependency);
  for (FactId id = graph_.node(choice.a).others; id != none; id = graph_.next_other(id, choice.a)) {
    effort_.count_look();
    if (is_at_least(graph_.fact(id))) add(id_of(graph_.fact(id)), graph_.fact(id).dependency);
  }
  const std::uint32_t most = program_.bound(bound).count;
  if (all <= most) return false;
  // Parts before wholes, then the greatest first. Neither need give the greatest sum.
  const auto by_specificity = [&](const Asked& one) { return numbers.specificity(one.id); };
  const auto add_up = [&] {
    std::vector<NumberOrder::AtLeastId> taken;
    DependencySet reasons = dependency;
    std::uint64_t sum = 0;
    for (const Asked& one : asked) {
      const auto is_apart = [&](NumberOrder::AtLeastId other) { return numbers.are_disjoint(one.id, other); };
      if (!std::ranges::all_of(taken, is_apart)) continue;
      taken.push_back(one.id);
      sum += one.count;
      reasons = graph_.unite(reasons, one.dependency);
      if (sum > most) break;
    }
    if (sum > most) dependency = reasons;
    return sum > most;
  };
  std::ranges::stable_sort(asked, std::ranges::greater(), &Asked::count);
  if (add_up()) return true;
  std::ranges::stable_sort(asked, std::ranges::greater(), by_specificity);
  return add_up();
}

// Whether bounds of the node, with the choice, allow fewer neighbours together than an at-least asks for.
bool Numbers::are_covered(const Choice& choice, DependencySet& dependency) const {
  const auto is_covered = [&](std::uint32_t at_least) {
    const std::uint32_t count = program_.numbers().count({at_least});
    return std::ranges::any_of(program_.covers().of(at_least),
                               [&](const Cover& cover) { return are_fewer(cover, count, choice, dependency); });
  };
  if (choice.kind == ChoiceKind::at_least) return is_covered(choice.predicate);
  if (choice.kind != ChoiceKind::at_most || !program_.covers().is_any_of(choice.predicate)) return false;
  for (FactId id = graph_.node(choice.a).others; id != none; id = graph_.next_other(id, choice.a)) {
    effort_.count_look();
    const Fact& fact = graph_.fact(id);
    if (fact.kind != FactKind::at_least || !is_covered(fact.predicate)) continue;
    dependency = graph_.unite(dependency, fact.dependency);
    return true;
  }
  return false;
}

// Whether the cover allows fewer neighbours than `count`. A bound that is used already costs nothing more.
bool Numbers::are_fewer(const Cover& cover, std::uint32_t count, const Choice& choice,
                        DependencySet& dependency) const {
  DependencySet reasons = dependency;
  if (!has_concepts(cover.guard, choice.a, reasons)) return false;
  const auto is_limit = [&](const Limit& limit) {
    if (limit.bound == no_predicate) return has_concepts(limit.guard, choice.a, reasons);
    return (choice.kind == ChoiceKind::at_most && choice.predicate == limit.bound) ||
           is_in_force(limit.bound, choice.a, reasons);
  };
  std::vector<std::uint32_t> used;
  std::uint64_t sum = 0;
  for (const std::vector<Limit>& limits : cover.alternatives) {
    const auto is_used = [&](const Limit& limit) { return std::ranges::find(used, limit.bound) != used.end(); };
    if (std::ranges::any_of(limits, is_used)) continue;
    const auto found = std::ranges::find_if(limits, is_limit);
    if (found == limits.end()) return false;
    sum += found->count;
    if (sum >= count) return false;
    if (found->bound != no_predicate) used.push_back(found->bound);
  }
  dependency = reasons;
  return true;
}

bool Numbers::has_concepts(std::span<const std::uint32_t> concepts, NodeId node, DependencySet& dependency) const {
  DependencySet reasons = dependency;
  for (const std::uint32_t id : concepts) {
    effort_.count_look();
    const FactId fact = graph_.find(FactKind::concept_of, id, node);
    if (fact == none) return false;
    reasons = graph_.unite(reasons, graph_.fact(fact).dependency);
  }
  dependency = reasons;
  return true;
}

}  // namespace geminga::hypertableau
