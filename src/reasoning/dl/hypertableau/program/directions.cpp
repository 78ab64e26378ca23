// Finding the clauses that lead from a concept to a neighbour.
#include "reasoning/dl/hypertableau/program/directions.hpp"

#include <set>

#include "base/sorted.hpp"

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::Clause;
using clauses::number;

namespace {

bool leads_to_neighbour(const Atom& atom) { return atom.kind == AtomKind::role && atom.first != atom.second; }

/// From the centre of the clause to the neighbour.
Direction outwards(const Atom& edge) { return direction_of(edge.predicate, edge.first != centre); }

}  // namespace

Directions::Directions(const clauses::ClauseSet& set, std::uint32_t concept_count)
    : of_concept_(concept_count), below_(2 * set.properties.size()) {
  for (const Clause& clause : set.clauses) look(clause);
  for (std::vector<Direction>& directions : of_concept_) add_below(directions);
  for (const clauses::AtLeast& one : set.at_leasts)
    of_at_least_.push_back(direction_of(number(one.role.property), one.role.is_inverse));
}

void Directions::look(const Clause& clause) {
  for (const Atom& edge : clause.body) {
    if (!leads_to_neighbour(edge)) continue;
    const bool is_inclusion = clause.body.size() == 1 && clause.head.size() == 1 && leads_to_neighbour(clause.head[0]);
    if (is_inclusion) {
      const Direction above = outwards(clause.head[0]);
      below_[above].push_back(outwards(edge));
      below_[reverse(above)].push_back(reverse(outwards(edge)));
    }
    for (const Atom& one : clause.body) {
      if (one.kind != AtomKind::concept_of) continue;
      if (one.first == centre) {
        of_concept_[one.predicate].push_back(outwards(edge));
      } else if (one.first == edge.first || one.first == edge.second) {
        of_concept_[one.predicate].push_back(reverse(outwards(edge)));
      }
    }
  }
}

void Directions::add_below(std::vector<Direction>& directions) const {
  base::sort_unique(directions);
  std::set<Direction> seen(directions.begin(), directions.end());
  for (std::size_t at = 0; at < directions.size(); ++at) {
    for (const Direction lower : below_[directions[at]]) {
      if (seen.insert(lower).second) directions.push_back(lower);
    }
  }
  base::sort_unique(directions);
}

}  // namespace geminga::hypertableau
