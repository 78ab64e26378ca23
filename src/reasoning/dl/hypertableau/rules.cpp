// How rules are matched. The rule is in rules.hpp.
#include "reasoning/dl/hypertableau/rules.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <utility>

#include "base/sorted.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::hypertableau {

using clauses::number;
using clauses::RuleAtom;
using clauses::RuleAtomKind;
using clauses::RuleTerm;
using clauses::RuleTermKind;

/// Finds out who is named. If that has changed, all facts are matched again.
void Rules::refresh() {
  if (!is_stale_ && merges_ == graph_.mark().trail && nodes_.size() == facts_.individuals().size()) return;
  std::vector<NodeId> nodes;
  std::vector<NodeId> named;
  is_named_.assign(graph_.node_count(), false);
  named_by_.assign(graph_.node_count(), no_dependency);
  for (std::size_t at = 0; at < facts_.individuals().size(); ++at) {
    DependencySet dependency = no_dependency;
    const NodeId node = graph_.current(facts_.individuals()[at], dependency);
    nodes.push_back(node);
    const owl::TermId term = set_.individuals[at];
    if (term == clauses::no_term || source_.kind(term) != owl::TermKind::individual || !graph_.is_active(node))
      continue;
    if (!is_named_[node] || dependency == no_dependency) named_by_[node] = dependency;
    is_named_[node] = true;
    named.push_back(node);
  }
  base::sort_unique(named);
  // After going back all facts below `processed_` have been matched with the individuals of that time.
  if (nodes != nodes_ && !is_stale_) processed_ = 0;
  nodes_ = std::move(nodes);
  named_ = std::move(named);
  is_stale_ = false;
  merges_ = graph_.mark().trail;
}

bool Rules::has_next() {
  if (set_.rules.empty() || facts_.individuals().empty()) return false;
  refresh();
  return processed_ == 0 || processed_ < graph_.facts().size();
}

void Rules::derive() {
  refresh();
  const bool is_first = processed_ == 0;
  if (is_first) {
    for (const std::uint32_t rule : plans_.untriggered()) match_if_known(rule);
  }
  while (processed_ < graph_.facts().size() && !is_over()) process(processed_++);
  if (is_over() || (seen_by_paths_ == graph_.facts().size() && !is_first)) return;
  for (const std::uint32_t rule : plans_.about_paths()) match_if_known(rule);
  seen_by_paths_ = static_cast<FactId>(graph_.facts().size());
  processed_ = std::max<FactId>(processed_, 1);  // the first fact was matched, if there is one
}

std::string Rules::find_open() {
  open_.clear();
  if (set_.rules.empty() || facts_.individuals().empty()) return open_;
  const bool may_be_open =
      has_unknown_ || std::ranges::any_of(set_.rules, [](const clauses::Rule& rule) { return !rule.problem.empty(); });
  if (!may_be_open) return open_;
  refresh();
  is_open_ = true;
  for (std::uint32_t rule = 0; rule < set_.rules.size() && open_.empty(); ++rule) match_whole(rule);
  is_open_ = false;
  return open_;
}

void Rules::match_if_known(std::uint32_t rule) {
  if (takes_unknown_for_true_ || plans_.is_known(rule)) match_whole(rule);
}

void Rules::match_whole(std::uint32_t rule) {
  bounds_.assign(set_.rules[rule].is_value.size(), {});
  match({&set_.rules[rule], none, plans_.whole(rule).steps, no_dependency, true});
}

void Rules::process(FactId id) {
  const Fact fact = graph_.fact(id);
  if (!graph_.is_active(fact.a) || fact.a >= is_named_.size() || !is_named_[fact.a]) return;
  effort_.count_look();
  const auto plans = fact.kind == FactKind::concept_of  ? plans_.of_concept(fact.predicate)
                     : fact.kind == FactKind::role      ? plans_.of_role(fact.predicate)
                     : fact.kind == FactKind::data_role ? plans_.of_data_role(fact.predicate)
                                                        : std::span<const RulePlan>();
  for (const RulePlan& plan : plans) {
    if (is_over()) return;
    start(plan, fact, id);
  }
}

void Rules::start(const RulePlan& plan, const Fact& fact, FactId id) {
  if (!takes_unknown_for_true_ && !plans_.is_known(plan.rule)) return;
  const clauses::Rule& rule = set_.rules[plan.rule];
  const RuleAtom& atom = rule.body[plan.trigger];
  bounds_.assign(rule.is_value.size(), {});
  Match match{&rule, id, plan.steps, fact.dependency, true};
  if (fact.kind == FactKind::concept_of) return go_on_with(atom.terms[0], {BoundKind::node, fact.a}, match);
  // The second argument is bound like a step of its own.
  const auto second = [&](Bound value) {
    DependencySet dependency = match.dependency;
    const Bound first = bound(atom.terms[0], dependency);
    const Bound node{BoundKind::node, fact.a};
    if (first.kind != BoundKind::nothing && !(first == node)) return;
    const bool is_variable = atom.terms[0].kind == RuleTermKind::variable;
    if (is_variable) bounds_[atom.terms[0].number] = node;
    match.dependency = graph_.unite(dependency, named_by_[fact.a]);
    go_on_with(atom.terms[1], value, match);
  };
  if (fact.kind == FactKind::role) return second({BoundKind::node, fact.b});
  if (!graph_.is_active(fact.b)) return;
  if (const auto value = value_of(fact.b, match.dependency); value && value->kind == BoundKind::literal) second(*value);
}

void Rules::match(Match match) {
  if (is_over() || (is_open_ && !open_.empty())) return;
  effort_.count_look();
  if (match.steps.empty()) return is_open_ ? note_open(match) : conclude(match);
  const RuleStep step = match.steps.front();
  match.steps = match.steps.subspan(1);
  if (!step.is_enumeration) return look_at(match.rule->body[step.number], match);
  for (std::size_t at = 0; at < named_.size() && !is_over(); ++at)
    go_on_with({RuleTermKind::variable, step.number}, {BoundKind::node, named_[at]}, match);
}

void Rules::go_on(Holds holds, Match match) {
  if (holds == Holds::no) return;
  has_unknown_ = has_unknown_ || holds == Holds::unknown;
  if (holds == Holds::unknown && !is_open_ && !takes_unknown_for_true_) return;
  match.is_sure = match.is_sure && holds == Holds::yes;
  this->match(match);
}

void Rules::go_on_with(const RuleTerm& term, Bound bound, Match match) {
  if (bound.kind == BoundKind::node) {
    if (bound.number >= is_named_.size() || !is_named_[bound.number]) return;
    match.dependency = graph_.unite(match.dependency, named_by_[bound.number]);
  }
  const Bound before = this->bound(term, match.dependency);
  if (before.kind != BoundKind::nothing) {
    const bool is_unknown = before.kind == BoundKind::some || bound.kind == BoundKind::some;
    return go_on(before == bound ? Holds::yes : is_unknown ? Holds::unknown : Holds::no, match);
  }
  bounds_[term.number] = bound;
  this->match(match);
  bounds_[term.number] = {};
}

Rules::Bound Rules::bound(const RuleTerm& term, DependencySet& dependency) {
  switch (term.kind) {
    case RuleTermKind::individual:
      return {BoundKind::node, graph_.current(facts_.individuals()[term.number], dependency)};
    case RuleTermKind::literal:
      return {BoundKind::literal, number(facts_.representative(owl::TermId{term.number}))};
    default:
      return bounds_[term.number];
  }
}

std::optional<Rules::Bound> Rules::value_of(NodeId node, DependencySet& dependency) {
  const Node& value = graph_.node(node);
  if (value.kind == NodeKind::constant)
    return Bound{BoundKind::literal, number(facts_.representative(owl::TermId{value.literal}))};
  bool is_free = false;
  if (const auto only = facts_.only_value(node, dependency, is_free)) return Bound{BoundKind::literal, number(*only)};
  // A value that may be one of infinitely many is none of those that are known.
  if (is_free) return std::nullopt;
  has_unknown_ = true;
  return Bound{BoundKind::some, node};
}

void Rules::look_at(const RuleAtom& atom, Match match) {
  switch (atom.kind) {
    case RuleAtomKind::named:
    case RuleAtomKind::concept_of: {
      const Bound node = bound(atom.terms[0], match.dependency);
      if (node.kind != BoundKind::node) return;
      if (atom.kind == RuleAtomKind::concept_of) {
        const FactId found = graph_.find(FactKind::concept_of, atom.predicate, node.number);
        if (found == none || found > match.limit) return;
        match.dependency = graph_.unite(match.dependency, graph_.fact(found).dependency);
      }
      return go_on_with(atom.terms[0], node, match);
    }
    case RuleAtomKind::role:
      return look_at_role(atom, match);
    case RuleAtomKind::path:
      return look_at_path(atom, match);
    case RuleAtomKind::data_role:
      return look_at_data_role(atom, match);
    case RuleAtomKind::data_range: {
      const Holds holds = is_in_range(atom, match.dependency);
      return go_on(holds, match);
    }
    case RuleAtomKind::equal: {
      const Bound first = bound(atom.terms[0], match.dependency);
      if (first.kind == BoundKind::nothing)
        return go_on_with(atom.terms[0], bound(atom.terms[1], match.dependency), match);
      return go_on_with(atom.terms[1], first, match);
    }
    case RuleAtomKind::built_in:
      return look_at_built_in(atom, match);
    case RuleAtomKind::unequal:
    case RuleAtomKind::unknown:
      return go_on(Holds::unknown, match);
  }
}

void Rules::look_at_role(const RuleAtom& atom, Match match) {
  const Bound first = bound(atom.terms[0], match.dependency);
  const Bound second = bound(atom.terms[1], match.dependency);
  if (first.kind == BoundKind::node && second.kind == BoundKind::node) {
    const FactId found = graph_.find(FactKind::role, atom.predicate, first.number, second.number);
    if (found == none || found > match.limit) return;
    match.dependency = graph_.unite(match.dependency, graph_.fact(found).dependency);
    // Constants must be named, too.
    if (!is_named_[first.number]) return;
    return go_on_with(atom.terms[1], second, match);
  }
  const bool is_forward = first.kind == BoundKind::node;
  const NodeId from = is_forward ? first.number : second.number;
  for (FactId id = is_forward ? graph_.node(from).out : graph_.node(from).in; id != none && !is_over();) {
    const Fact fact = graph_.fact(id);
    const FactId next = is_forward ? fact.next_a : fact.next_b;
    effort_.count_look();
    const NodeId to = is_forward ? fact.b : fact.a;
    if (id <= match.limit && fact.kind == FactKind::role && fact.predicate == atom.predicate && graph_.is_active(to)) {
      Match more = match;
      more.dependency = graph_.unite(match.dependency, fact.dependency);
      go_on_with(atom.terms[is_forward ? 1 : 0], {BoundKind::node, to}, more);
    }
    id = next;
  }
}

void Rules::look_at_data_role(const RuleAtom& atom, Match match) {
  const Bound object = bound(atom.terms[0], match.dependency);
  if (object.kind != BoundKind::node) return;
  for (FactId id = graph_.node(object.number).out; id != none && !is_over();) {
    const Fact fact = graph_.fact(id);
    effort_.count_look();
    if (id <= match.limit && fact.kind == FactKind::data_role && fact.predicate == atom.predicate &&
        graph_.is_active(fact.b)) {
      Match more = match;
      more.dependency = graph_.unite(match.dependency, fact.dependency);
      const auto value = value_of(fact.b, more.dependency);
      if (value && (is_open_ || value->kind == BoundKind::literal)) {
        more.is_sure = more.is_sure && value->kind == BoundKind::literal;
        go_on_with(atom.terms[1], *value, more);
      }
    }
    id = fact.next_a;
  }
}

// Walks from the first node along the automaton of the property. What blocked nodes lead to is not known.
void Rules::look_at_path(const RuleAtom& atom, Match match) {
  const owl::Automaton& automaton = set_.paths[atom.predicate];
  const Bound first = bound(atom.terms[0], match.dependency);
  if (first.kind != BoundKind::node) return;
  struct Place {
    NodeId node;
    owl::Automaton::State state;
    DependencySet dependency;
  };
  std::deque<Place> open{{first.number, owl::Automaton::begin, match.dependency}};
  std::set<std::pair<NodeId, owl::Automaton::State>> seen{{first.number, owl::Automaton::begin}};
  std::vector<Place> reached;
  bool meets_blocked = false;
  while (!open.empty() && !effort_.is_over_limit()) {
    const Place place = open.front();
    open.pop_front();
    if (automaton.is_final(place.state)) reached.push_back(place);
    const Node& node = graph_.node(place.node);
    meets_blocked = meets_blocked || (node.kind == NodeKind::tree && node.is_blocked);
    for (const owl::Automaton::Move& move : automaton.moves()) {
      if (move.from != place.state) continue;
      const bool is_forward = !move.label.is_inverse;
      for (FactId id = is_forward ? graph_.node(place.node).out : graph_.node(place.node).in; id != none;
           id = is_forward ? graph_.fact(id).next_a : graph_.fact(id).next_b) {
        const Fact& fact = graph_.fact(id);
        effort_.count_look();
        const NodeId to = is_forward ? fact.b : fact.a;
        if (fact.kind != FactKind::role || fact.predicate != number(move.label.property) || !graph_.is_active(to))
          continue;
        if (!seen.insert({to, move.to}).second) continue;
        open.push_back({to, move.to, graph_.unite(place.dependency, fact.dependency)});
      }
    }
  }
  for (const Place& place : reached) {
    Match more = match;
    more.dependency = place.dependency;
    go_on_with(atom.terms[1], {BoundKind::node, place.node}, more);
  }
  if (!meets_blocked) return;
  has_unknown_ = true;
  if (!is_open_) return;
  match.is_sure = false;
  for (std::size_t at = 0; at < named_.size() && !is_over(); ++at)
    go_on_with(atom.terms[1], {BoundKind::node, named_[at]}, match);
}

Holds Rules::is_in_range(const RuleAtom& atom, DependencySet& dependency) {
  const Bound value = bound(atom.terms[0], dependency);
  if (value.kind != BoundKind::literal) return Holds::unknown;
  const auto is_in = facts_.is_in(owl::TermId{value.number}, atom.predicate);
  return !is_in ? Holds::unknown : *is_in ? Holds::yes : Holds::no;
}

Holds Rules::evaluate_built_in(const RuleAtom& atom, std::optional<RuleTerm>& unbound, Bound& result,
                               DependencySet& dependency) {
  std::vector<std::optional<Value>> values;
  std::size_t missing = atom.terms.size();
  for (std::size_t at = 0; at < atom.terms.size(); ++at) {
    const Bound one = bound(atom.terms[at], dependency);
    values.emplace_back();
    if (one.kind == BoundKind::nothing) {
      if (missing != atom.terms.size()) return Holds::unknown;
      missing = at;
      continue;
    }
    if (one.kind == BoundKind::literal) values.back() = facts_.value(owl::TermId{one.number});
    if (!values.back()) return Holds::unknown;
  }
  const Holds holds = evaluate(static_cast<clauses::BuiltIn>(atom.predicate), values);
  if (holds != Holds::yes || missing == atom.terms.size()) return holds;
  if (!values[missing]) return Holds::unknown;
  const auto made = facts_.made_value(*values[missing]);
  if (!made) return Holds::unknown;
  unbound = atom.terms[missing];
  result = {BoundKind::literal, number(*made)};
  return Holds::yes;
}

void Rules::look_at_built_in(const RuleAtom& atom, Match match) {
  effort_.count_step();
  std::optional<RuleTerm> unbound;
  Bound result;
  const Holds holds = evaluate_built_in(atom, unbound, result, match.dependency);
  if (unbound) return go_on_with(*unbound, result, match);
  go_on(holds, match);
}

}  // namespace geminga::hypertableau
