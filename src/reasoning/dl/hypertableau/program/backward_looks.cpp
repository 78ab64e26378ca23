#include "reasoning/dl/hypertableau/program/backward_looks.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::Clause;
using clauses::number;
using clauses::Variable;

namespace {

bool joins_nodes(const Atom& atom) { return atom.kind == AtomKind::role && atom.first != atom.second; }

}  // namespace

BackwardLooks::BackwardLooks(const clauses::ClauseSet& set, const Denials& denials)
    : is_looked_along_(2 * set.properties.size()),
      is_of_all_(2 * set.properties.size()),
      guards_(2 * set.properties.size()) {
  find_inverses(set);
  if (!has_inverses_) return;
  for (const Clause& clause : set.clauses) look(clause);
  const auto direction = [](clauses::Role role) { return direction_of(number(role.property), role.is_inverse); };
  for (const clauses::AtMost& one : set.at_mosts) is_of_all_[direction(one.role)] = true;
  const auto is_nominal = [](const clauses::Concept& one) { return one.kind == clauses::ConceptKind::nominal; };
  are_of_at_leasts_ = denials.look_around() || std::ranges::any_of(set.concepts, is_nominal);
  for (Direction along = 0; along < guards_.size(); ++along) {
    base::sort_unique(guards_[along]);
    is_looked_along_[along] = is_of_all_[along] || !guards_[along].empty();
  }
  for (const clauses::AtLeast& one : set.at_leasts) {
    if (are_of_at_leasts_) is_looked_along_[direction(one.role)] = true;
  }
}

void BackwardLooks::find_inverses(const clauses::ClauseSet& set) {
  const auto is_inverse = [](const auto& one) { return one.role.is_inverse; };
  has_inverses_ = std::ranges::any_of(set.at_leasts, is_inverse) || std::ranges::any_of(set.at_mosts, is_inverse);
  for (const Clause& clause : set.clauses) note_inverses(clause);
}

// Edges lead from parents to children, unless a head turns one round; a clause that goes along an edge in one direction
// and along another in the other sees the parent and a child at once. A clause with equalities may be a bound.
void BackwardLooks::note_inverses(const Clause& clause) {
  bool forwards = std::ranges::any_of(clause.head, [](const Atom& atom) { return atom.kind == AtomKind::equal; });
  bool backwards = false;
  const auto note = [&](const Atom& atom) {
    if (joins_nodes(atom)) (atom.first == centre ? forwards : backwards) = true;
  };
  std::ranges::for_each(clause.body, note);
  std::ranges::for_each(clause.head, note);
  has_inverses_ = has_inverses_ || (forwards && backwards);
}

void BackwardLooks::look(const Clause& clause) {
  Variable neighbour = centre;
  bool has_two = false;
  const auto note = [&](const Atom& atom) {
    if (!joins_nodes(atom)) return;
    const Variable other = std::max(atom.first, atom.second);
    has_two = has_two || (neighbour != centre && neighbour != other);
    neighbour = other;
  };
  std::ranges::for_each(clause.body, note);
  std::ranges::for_each(clause.head, note);
  if (!has_two) return;
  const auto is_guard = [](const Atom& atom) {
    return atom.kind == AtomKind::concept_of && atom.first == centre && atom.predicate != number(clauses::thing);
  };
  const auto guard = std::ranges::find_if(clause.body, is_guard);
  const auto look_along = [&](const Atom& atom) {
    if (!joins_nodes(atom)) return;
    const Direction direction = direction_of(atom.predicate, atom.first != centre);
    if (guard == clause.body.end()) {
      is_of_all_[direction] = true;
    } else {
      guards_[direction].push_back(guard->predicate);
    }
  };
  std::ranges::for_each(clause.body, look_along);
  std::ranges::for_each(clause.head, look_along);
}

}  // namespace geminga::hypertableau
