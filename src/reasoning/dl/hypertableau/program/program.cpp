// Plans for each body atom, and the taking out of number restrictions.
#include "reasoning/dl/hypertableau/program/program.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "base/sorted.hpp"
#include "reasoning/dl/clauses/counted_neighbours.hpp"
#include "reasoning/dl/hypertableau/program/union_superclasses.hpp"

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::Clause;
using clauses::number;
using clauses::Variable;

Program::Program(const clauses::ClauseSet& set, bool counts)
    : set_(set),
      domains_(set),
      directions_(set, domains_.concept_count()),
      denials_(set),
      backward_looks_(set, denials_),
      unions_(set),
      parts_(set),
      burdens_(set, domains_, denials_),
      counts_(counts) {
  const std::size_t count = std::size_t{mark_of_question()} + 1;
  by_concept_.resize(count);
  bounds_of_filler_.resize(count);
  bounds_of_guard_.resize(count);
  by_role_.resize(set.properties.size());
  bounds_of_role_.resize(set.properties.size());
  bounds_of_loop_.resize(set.properties.size());
  by_data_role_.resize(set.data_properties.size());
  bounds_of_data_role_.resize(set.data_properties.size());
  disjoint_with_.resize(set.data_properties.size());
  for (const clauses::AtMost& one : set.at_mosts) {
    Bound bound{one.count, false, one.role.is_inverse, number(one.role.property)};
    if (one.filler != clauses::thing) bound.filler = number(one.filler);
    bound_of_at_most_.push_back(index_of(bound));
  }
  for (const clauses::DataAtMost& one : set.data_at_mosts) {
    Bound bound{one.count, true, false, number(one.property)};
    if (number(one.range) != 0) bound.unless = number(one.outside);
    bound_of_data_at_most_.push_back(index_of(bound));
  }
  for (const clauses::Concept& one : set.concepts) {
    has_nominals_ = has_nominals_ || one.kind == clauses::ConceptKind::nominal;
  }
  for (const Clause& clause : set.clauses) add_clause(clause);
  for (const Clause& clause : domains_.clauses()) add_plans(clause);
  find_disjoint_concepts();
  if (counts_) compare_numbers();
  const clauses::CountedNeighbours counted(set, clauses::UsedAtMosts::all);
  for (const clauses::AtLeast& one : set.at_leasts) needed_.push_back(counts_ ? counted.enough(one) : one.count);
}

void Program::compare_numbers() {
  std::vector<std::uint32_t> fillers;
  for (const Bound& bound : bounds_) {
    if (bound.filler != no_predicate) fillers.push_back(bound.filler);
  }
  base::sort_unique(fillers);
  const UnionSuperclasses unions(set_, fillers);
  for (const Clause& clause : unions.clauses()) add_plans(clause);
  numbers_ = NumberOrder(set_, unions.clauses(), bounds_);
  covers_ = Covers(set_, unions.clauses(), bounds_);
}

std::uint32_t Program::bound_of_atom(const Atom& atom) const {
  return atom.kind == AtomKind::at_most ? bound_of_at_most_[atom.predicate] : bound_of_data_at_most_[atom.predicate];
}

std::uint32_t Program::index_of(const Bound& bound) {
  const auto id = static_cast<std::uint32_t>(bounds_.size());
  const auto [found, is_new] = index_.try_emplace(bound, id);
  if (!is_new) return found->second;
  bounds_.push_back(bound);
  is_global_.push_back(false);
  conditional_.emplace_back();
  (bound.is_data ? bounds_of_data_role_ : bounds_of_role_)[bound.property].push_back(id);
  if (bound.filler != no_predicate) bounds_of_filler_[bound.filler].push_back(id);
  return id;
}

void Program::add_clause(const Clause& clause) {
  if (!take_bound(clause) && !take_disjointness(clause)) add_plans(clause);
}

bool Program::take_disjointness(const Clause& clause) {
  // U(x,v), V(x,v) -> false  says that values of U and of V differ, which values that are not chosen yet must know.
  const bool has_shape =
      clause.head.empty() && clause.body.size() == 2 && std::ranges::all_of(clause.body, [](const Atom& atom) {
        return atom.kind == AtomKind::data_role && atom.second == 1;
      });
  if (!has_shape) return false;
  const std::uint32_t first = clause.body[0].predicate;
  const std::uint32_t second = clause.body[1].predicate;
  disjoint_with_[first].push_back(second);
  disjoint_with_[second].push_back(first);
  return true;
}

namespace {

/// The atoms of a clause about one neighbour.
struct NeighbourAtoms {
  std::vector<Atom> body;  ///< first and second with the neighbour as 1
  std::vector<Atom> head;
};

Atom as_first(Atom atom, Variable neighbour) {
  if (atom.first == neighbour) atom.first = 1;
  if (atom.second == neighbour) atom.second = 1;
  return atom;
}

bool is_role(AtomKind kind) { return kind == AtomKind::role || kind == AtomKind::data_role; }

/// The at-most of `count` neighbours like this one; nothing if its atoms are not those of an at-most.
std::optional<Bound> bound_of(const NeighbourAtoms& one, std::uint32_t count) {
  if (one.body.size() > 2 || one.head.size() > 1) return std::nullopt;
  const auto role = std::ranges::find_if(one.body, [](const Atom& atom) { return is_role(atom.kind); });
  if (role == one.body.end() || role->first == role->second) return std::nullopt;
  Bound bound{count, role->kind == AtomKind::data_role, role->first != centre, role->predicate};
  for (const Atom& atom : one.body) {
    if (is_role(atom.kind)) {
      if (&atom != &*role) return std::nullopt;
    } else {
      bound.filler = atom.predicate;
    }
  }
  if (one.head.empty()) return bound;
  const AtomKind kind = one.head.front().kind;
  if (bound.filler != no_predicate || (kind != AtomKind::concept_of && kind != AtomKind::data_range))
    return std::nullopt;
  bound.unless = one.head.front().predicate;
  return bound;
}

}  // namespace

bool Program::take_bound(const Clause& clause) {
  //   guard(x), R(x,y1), B(y1), ..., R(x,yn+1), B(yn+1) -> alternatives(x) or y1=y2 or y1=y3 or ...
  // is  guard -> alternatives or <= n R.B.
  std::vector<NeighbourAtoms> neighbours;
  ConditionalBound rest;
  std::size_t equalities = 0;
  const auto neighbour = [&](Variable at) -> NeighbourAtoms& {
    if (neighbours.size() < at) neighbours.resize(at);
    return neighbours[at - 1];
  };
  for (const Atom& atom : clause.body) {
    const Variable other = std::max(atom.first, atom.second);
    if (other == centre) {
      rest.guard.push_back(atom);
    } else {
      neighbour(other).body.push_back(as_first(atom, other));
    }
  }
  for (const Atom& atom : clause.head) {
    if (atom.kind == AtomKind::equal || atom.kind == AtomKind::data_equal) {
      if (atom.first == centre || atom.second == centre) return false;
      ++equalities;
    } else if (const Variable other = std::max(atom.first, atom.second); other == centre) {
      rest.alternatives.push_back(atom);
    } else {
      neighbour(other).head.push_back(as_first(atom, other));
    }
  }
  const std::size_t count = neighbours.size();
  if (count < 2 || equalities != count * (count - 1) / 2) return false;
  const NeighbourAtoms& first = neighbours.front();
  const bool are_alike = std::ranges::all_of(
      neighbours, [&](const NeighbourAtoms& one) { return one.body == first.body && one.head == first.head; });
  if (!are_alike) return false;
  const auto bound = bound_of(first, static_cast<std::uint32_t>(count - 1));
  if (!bound) return false;
  const std::uint32_t id = index_of(*bound);
  if (rest.guard.empty() && rest.alternatives.empty()) {
    is_global_[id] = true;
    return true;
  }
  for (const Atom& atom : rest.guard) {
    if (atom.kind == AtomKind::concept_of) bounds_of_guard_[atom.predicate].push_back(id);
    if (atom.kind == AtomKind::role) bounds_of_loop_[atom.predicate].push_back(id);
  }
  conditional_[id].push_back(std::move(rest));
  return true;
}

bool Program::brings(std::uint32_t id, std::uint32_t bound) const {
  return std::ranges::any_of(conditional_[bound], [id](const ConditionalBound& rule) {
    return rule.alternatives.empty() && rule.guard.size() == 1 && rule.guard.front().kind == AtomKind::concept_of &&
           rule.guard.front().predicate == id;
  });
}

void Program::add_plans(const Clause& clause) {
  const auto head_begin = static_cast<std::uint32_t>(heads_.size());
  heads_.insert(heads_.end(), clause.head.begin(), clause.head.end());
  const auto head_end = static_cast<std::uint32_t>(heads_.size());
  if (clause.body.empty()) {
    needs_thing_ = true;
    by_concept_[number(clauses::thing)].push_back({centre, centre, 0, 0, head_begin, head_end});
  }
  for (std::size_t trigger = 0; trigger < clause.body.size(); ++trigger)
    add_plan(clause, trigger, head_begin, head_end);
}

void Program::add_plan(const Clause& clause, std::size_t trigger, std::uint32_t head_begin, std::uint32_t head_end) {
  const Atom& start = clause.body[trigger];
  Plan plan{start.first, start.second, static_cast<std::uint32_t>(steps_.size()), 0, head_begin, head_end};
  std::vector<Atom> open = clause.body;
  open.erase(open.begin() + static_cast<std::ptrdiff_t>(trigger));
  std::vector<bool> is_bound(256, false);
  is_bound[start.first] = true;
  if (start.kind != AtomKind::concept_of) is_bound[start.second] = true;
  const auto is_checkable = [&](const Atom& atom) {
    return is_bound[atom.first] && (atom.kind == AtomKind::concept_of || is_bound[atom.second]);
  };
  const auto is_reachable = [&](const Atom& atom) {
    return is_role(atom.kind) && (is_bound[atom.first] || is_bound[atom.second]);
  };
  while (!open.empty()) {
    // Atoms that can be looked up come first, then atoms that lead to another node.
    auto next = std::ranges::find_if(open, is_checkable);
    const bool is_check = next != open.end();
    if (!is_check) next = std::ranges::find_if(open, is_reachable);
    if (next == open.end()) break;  // cannot be: every variable is connected with the centre
    Step step{StepKind::check_concept, next->first, next->second, next->predicate};
    const bool is_data = next->kind == AtomKind::data_role;
    if (is_role(next->kind)) {
      if (is_check) {
        step.kind = is_data ? StepKind::check_data : StepKind::check_role;
      } else if (is_bound[next->first]) {
        step.kind = is_data ? StepKind::each_value : StepKind::each_out;
        is_bound[next->second] = true;
      } else {
        step.kind = is_data ? StepKind::each_subject : StepKind::each_in;
        is_bound[next->first] = true;
      }
    }
    steps_.push_back(step);
    open.erase(next);
  }
  plan.steps_end = static_cast<std::uint32_t>(steps_.size());
  auto& table = start.kind == AtomKind::concept_of ? by_concept_
                : start.kind == AtomKind::role     ? by_role_
                                                   : by_data_role_;
  table[start.predicate].push_back(plan);
}

void Program::find_disjoint_concepts() {
  // A(x) -> B(x), B(x), C(x) -> false: C excludes A.
  const std::size_t count = domains_.concept_count();
  std::vector<std::vector<std::uint32_t>> above(count);
  std::vector<std::vector<std::uint32_t>> excluded(count);
  std::vector<bool> is_chosen(count, false);
  const auto is_concept = [](const Atom& atom) { return atom.kind == AtomKind::concept_of && atom.first == centre; };
  const auto look = [&](const Clause& clause) {
    for (const Atom& atom : clause.head) {
      if (clause.head.size() == 1) break;
      if (atom.kind == AtomKind::concept_of) is_chosen[atom.predicate] = true;
      if (atom.kind == AtomKind::at_least) is_chosen[number(set_.at_leasts[atom.predicate].filler)] = true;
    }
    if (!std::ranges::all_of(clause.body, is_concept) || !std::ranges::all_of(clause.head, is_concept)) return;
    if (clause.body.size() == 1 && clause.head.size() == 1) {
      above[clause.body[0].predicate].push_back(clause.head[0].predicate);
    } else if (clause.body.size() == 2 && clause.head.empty()) {
      excluded[clause.body[0].predicate].push_back(clause.body[1].predicate);
      excluded[clause.body[1].predicate].push_back(clause.body[0].predicate);
    }
  };
  std::ranges::for_each(set_.clauses, look);
  std::ranges::for_each(domains_.clauses(), look);
  for (const clauses::AtLeast& one : set_.at_leasts) {
    if (one.count > 1) is_chosen[number(one.filler)] = true;  // neighbours that may have to be told apart
  }
  told_below_.resize(count);
  for (std::uint32_t id = 0; id < count; ++id) {
    for (const std::uint32_t super : above[id]) told_below_[super].push_back(id);
  }
  disjoint_concepts_.resize(std::size_t{mark_of_question()} + 1);
  for (std::uint32_t id = 0; id < count; ++id) {
    if (is_chosen[id] || id >= set_.concepts.size()) find_excluded(id, above, excluded);
  }
}

void Program::find_excluded(std::uint32_t id, const std::vector<std::vector<std::uint32_t>>& above,
                            const std::vector<std::vector<std::uint32_t>>& excluded) {
  std::vector<std::uint32_t> open = {id};
  std::set<std::uint32_t> seen = {id};
  auto& result = disjoint_concepts_[id];
  for (std::size_t at = 0; at < open.size(); ++at) {
    result.insert(result.end(), excluded[open[at]].begin(), excluded[open[at]].end());
    for (const std::uint32_t super : above[open[at]]) {
      if (seen.insert(super).second) open.push_back(super);
    }
  }
  base::sort_unique(result);
}

}  // namespace geminga::hypertableau
