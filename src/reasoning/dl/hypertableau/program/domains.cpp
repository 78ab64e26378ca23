// Finding the clauses with a neighbour that does not matter, and the hierarchy of roles.
#include "reasoning/dl/hypertableau/program/domains.hpp"

#include <algorithm>
#include <set>

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::Clause;
using clauses::number;

namespace {

bool is_of_centre(const Atom& atom) { return atom.first == centre && atom.second == centre; }
bool is_edge(const Atom& atom) { return atom.kind == AtomKind::role || atom.kind == AtomKind::data_role; }

}  // namespace

Domains::Domains(const clauses::ClauseSet& set) : concept_count_(static_cast<std::uint32_t>(set.concepts.size())) {
  for (const Clause& clause : set.clauses) {
    copy(clause);
    note_hierarchy(clause);
  }
  for (const clauses::AtLeast& one : set.at_leasts) {
    of_at_least_.push_back(implied_by({false, number(one.role.property), one.role.is_inverse}));
  }
  for (const clauses::DataAtLeast& one : set.data_at_leasts) {
    of_data_at_least_.push_back(implied_by({true, number(one.property), false}));
  }
}

void Domains::copy(const Clause& clause) {
  const auto others = std::ranges::count_if(clause.body, [](const Atom& atom) { return !is_of_centre(atom); });
  if (others != 1 || !std::ranges::all_of(clause.head, is_of_centre)) return;
  Clause copied = clause;
  const auto edge = std::ranges::find_if(copied.body, [](const Atom& atom) { return !is_of_centre(atom); });
  if (!is_edge(*edge)) return;
  const Direction direction{edge->kind == AtomKind::data_role, edge->predicate, edge->first != centre};
  const auto [found, is_new] = concepts_.try_emplace(direction, concept_count_);
  if (is_new) ++concept_count_;
  *edge = {AtomKind::concept_of, centre, centre, found->second};
  clauses_.push_back(std::move(copied));
}

void Domains::note_hierarchy(const Clause& clause) {
  if (clause.body.size() != 1 || clause.head.size() != 1) return;
  const Atom& sub = clause.body[0];
  const Atom& super = clause.head[0];
  if (!is_edge(sub) || super.kind != sub.kind || is_of_centre(sub) || is_of_centre(super)) return;
  const bool is_data = sub.kind == AtomKind::data_role;
  const bool is_turned = sub.first != super.first;
  above_[{is_data, sub.predicate, false}].push_back({is_data, super.predicate, is_turned});
  if (!is_data) above_[{false, sub.predicate, true}].push_back({false, super.predicate, !is_turned});
}

std::vector<std::uint32_t> Domains::implied_by(const Direction& start) const {
  std::set<Direction> seen = {start};
  std::vector<Direction> open = {start};
  std::vector<std::uint32_t> result;
  while (!open.empty()) {
    const Direction one = open.back();
    open.pop_back();
    if (const auto found = concepts_.find(one); found != concepts_.end()) result.push_back(found->second);
    const auto above = above_.find(one);
    if (above == above_.end()) continue;
    for (const Direction& super : above->second) {
      if (seen.insert(super).second) open.push_back(super);
    }
  }
  std::ranges::sort(result);
  return result;
}

}  // namespace geminga::hypertableau
