// Hierarchies of the clauses of a set.
#include "reasoning/dl/hypertableau/program/hierarchy.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::Clause;

std::vector<std::uint32_t> Hierarchy::all_above(std::uint32_t start) {
  std::vector<std::uint32_t> found = {start};
  found_by_[start] = ++searches_;
  for (std::size_t at = 0; at < found.size(); ++at) {
    for (const std::uint32_t next : above_[found[at]]) {
      if (found_by_[next] != searches_) found.push_back(next);
      found_by_[next] = searches_;
    }
  }
  base::sort_unique(found);
  return found;
}

Hierarchy hierarchy_of_concepts(const clauses::ClauseSet& set, std::span<const Clause> inclusions) {
  Hierarchy result(set.concepts.size());
  const auto look = [&](const Clause& clause) {
    if (clause.body.size() != 1 || clause.head.size() != 1) return;
    const Atom& low = clause.body.front();
    const Atom& high = clause.head.front();
    if (low.kind == AtomKind::concept_of && high.kind == AtomKind::concept_of)
      result.add(low.predicate, high.predicate);
  };
  std::ranges::for_each(set.clauses, look);
  std::ranges::for_each(inclusions, look);
  return result;
}

Hierarchy hierarchy_of_roles(const clauses::ClauseSet& set) {
  const auto first_data = static_cast<std::uint32_t>(set.properties.size()) * 2;
  Hierarchy result(first_data + set.data_properties.size());
  for (const Clause& clause : set.clauses) {
    if (clause.body.size() != 1 || clause.head.size() != 1) continue;
    const Atom& low = clause.body.front();
    const Atom& high = clause.head.front();
    if (low.kind == AtomKind::role && high.kind == AtomKind::role && low.first != low.second &&
        high.first != high.second) {
      // R(x,y) -> S(x,y) or S(y,x), and the same of the inverses.
      const std::uint32_t turn = low.first == high.first ? 0U : 1U;
      result.add(low.predicate * 2, (high.predicate * 2) ^ turn);
      result.add(low.predicate * 2 + 1, (high.predicate * 2 + 1) ^ turn);
    } else if (low.kind == AtomKind::data_role && high.kind == AtomKind::data_role) {
      result.add(first_data + low.predicate, first_data + high.predicate);
    }
  }
  return result;
}

}  // namespace geminga::hypertableau
