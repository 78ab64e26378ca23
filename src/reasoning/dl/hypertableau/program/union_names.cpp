#include "reasoning/dl/hypertableau/program/union_names.hpp"

#include <algorithm>

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::Clause;
using clauses::number;

UnionNames::UnionNames(const clauses::ClauseSet& set) : alternatives_(set.concepts.size()) {
  std::vector<std::uint32_t> uses(set.concepts.size(), 0);
  const auto is_concept = [](const Atom& atom) { return atom.kind == AtomKind::concept_of && atom.first == centre; };
  for (const Clause& clause : set.clauses) {
    for (const Atom& atom : clause.body) {
      if (atom.kind == AtomKind::concept_of) ++uses[atom.predicate];
    }
    if (clause.body.size() != 1 || clause.head.empty() || !is_concept(clause.body.front()) ||
        !std::ranges::all_of(clause.head, is_concept))
      continue;
    for (const Atom& atom : clause.head) alternatives_[clause.body.front().predicate].push_back(atom.predicate);
  }
  // More instances of these would count.
  for (const clauses::AtMost& bound : set.at_mosts) ++uses[number(bound.filler)];
  for (const clauses::Key& key : set.keys) ++uses[number(key.of)];
  for (std::uint32_t id = 0; id < alternatives_.size(); ++id) {
    if (uses[id] != 1 || set.concepts[id].kind != clauses::ConceptKind::auxiliary) alternatives_[id].clear();
  }
}

}  // namespace geminga::hypertableau
