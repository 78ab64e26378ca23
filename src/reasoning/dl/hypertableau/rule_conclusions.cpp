// The conclusions of a match.
#include <algorithm>

#include "reasoning/dl/hypertableau/rules.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::hypertableau {

using clauses::RuleAtom;
using clauses::RuleAtomKind;

std::optional<Choice> Rules::choice_of(const RuleAtom& head, DependencySet& dependency, bool& is_false) {
  const auto node = [&](std::size_t at) { return bound(head.terms[at], dependency).number; };
  const auto value = [&](std::size_t at) {
    return facts_.constant(owl::TermId{bound(head.terms[at], dependency).number});
  };
  switch (head.kind) {
    case RuleAtomKind::concept_of:
      return Choice{ChoiceKind::concept_of, head.predicate, node(0), node(0)};
    case RuleAtomKind::role:
      return Choice{ChoiceKind::role, head.predicate, node(0), node(1)};
    case RuleAtomKind::data_role:
      return Choice{ChoiceKind::data_role, head.predicate, node(0), value(1)};
    case RuleAtomKind::data_range:
      return Choice{ChoiceKind::data_range, head.predicate, value(0), value(0)};
    case RuleAtomKind::equal:
      if (node(0) == node(1)) return std::nullopt;
      return Choice{ChoiceKind::equal, 0, node(0), node(1)};
    case RuleAtomKind::unequal:
      is_false = node(0) == node(1);
      return std::nullopt;
    case RuleAtomKind::built_in: {
      std::optional<clauses::RuleTerm> unbound;
      Bound result;
      const Holds holds = evaluate_built_in(head, unbound, result, dependency);
      has_unknown_ = has_unknown_ || holds == Holds::unknown;
      is_false = holds == Holds::no;
      return std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

bool Rules::can_conclude(const Match& match) {
  const auto is_concrete = [&](const RuleAtom& head) {
    return head.kind != RuleAtomKind::unknown && head.kind != RuleAtomKind::built_in &&
           std::ranges::all_of(head.terms, [&](const clauses::RuleTerm& term) {
             DependencySet ignored = no_dependency;
             const BoundKind kind = bound(term, ignored).kind;
             return kind == BoundKind::node || kind == BoundKind::literal;
           });
  };
  return std::ranges::all_of(match.rule->heads, is_concrete) &&
         std::ranges::all_of(match.rule->alternatives, is_concrete);
}

void Rules::conclude(const Match& match) {
  if (!match.is_sure && !can_conclude(match)) return;  // find_open() names it
  DependencySet dependency = match.dependency;
  std::vector<Choice> others;
  for (const RuleAtom& alternative : match.rule->alternatives) {
    bool is_false = false;
    const auto choice = choice_of(alternative, dependency, is_false);
    if (!choice) return;  // they are one
    others.push_back(*choice);
  }
  const auto add = [&](std::optional<Choice> choice) {
    std::vector<Choice> alternatives = others;
    if (choice) alternatives.push_back(*choice);
    if (alternatives.empty()) return facts_.clash(dependency);
    if (std::ranges::any_of(alternatives, [&](const Choice& one) { return facts_.holds(one); })) return;
    if (alternatives.size() == 1) return facts_.apply(alternatives.front(), dependency);
    disjunctions_.add(alternatives, dependency);
  };
  if (match.rule->heads.empty()) return add(std::nullopt);
  for (const RuleAtom& head : match.rule->heads) {
    if (facts_.has_clash()) return;
    bool is_false = false;
    const auto choice = choice_of(head, dependency, is_false);
    if (choice || is_false) {
      add(choice);
    } else if (head.kind == RuleAtomKind::unequal && others.empty()) {
      facts_.add_unequal(bound(head.terms[0], dependency).number, bound(head.terms[1], dependency).number, dependency);
    }
  }
}

bool Rules::is_satisfied(const RuleAtom& head) {
  DependencySet ignored = no_dependency;
  for (const clauses::RuleTerm& term : head.terms) {
    const BoundKind kind = bound(term, ignored).kind;
    if (kind == BoundKind::some || kind == BoundKind::nothing) return false;
  }
  switch (head.kind) {
    case RuleAtomKind::unknown:
      return false;
    case RuleAtomKind::built_in: {
      std::optional<clauses::RuleTerm> unbound;
      Bound result;
      return evaluate_built_in(head, unbound, result, ignored) == Holds::yes;
    }
    case RuleAtomKind::data_range:
      return is_in_range(head, ignored) == Holds::yes;
    default: {
      bool is_false = false;
      const auto choice = choice_of(head, ignored, is_false);
      return choice ? facts_.holds(*choice) : !is_false;
    }
  }
}

void Rules::note_open(const Match& match) {
  const auto holds = [&](const RuleAtom& atom) { return is_satisfied(atom); };
  if (std::ranges::any_of(match.rule->alternatives, holds)) return;
  const bool is_kept = !match.rule->heads.empty() && std::ranges::all_of(match.rule->heads, holds);
  if (is_kept) return;
  open_ = match.rule->problem.empty() ? "values in a swrl:Imp that are not known" : std::string(match.rule->problem);
  const owl::Axiom axiom = source_.axiom(match.rule->axiom);
  const std::string& file = source_.files()[static_cast<std::size_t>(axiom.file)].path;
  if (axiom.line != 0) open_ += " (" + file + ':' + std::to_string(axiom.line) + ')';
}

}  // namespace geminga::hypertableau
