#include "reasoning/dl/hypertableau/program/denials.hpp"

#include <algorithm>

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::ConceptKind;
using clauses::number;

Denials::Denials(const clauses::ClauseSet& set) : denied_(set.concepts.size()) {
  for (const clauses::Concept& one : set.concepts) is_denial_.push_back(one.kind == ConceptKind::auxiliary);
  for (const clauses::Clause& clause : set.clauses) look(set, clause);
  // More instances of these would count.
  for (const clauses::AtMost& bound : set.at_mosts) is_denial_[number(bound.filler)] = false;
  for (const clauses::Key& key : set.keys) is_denial_[number(key.of)] = false;
  for (std::uint32_t id = 0; id < denied_.size(); ++id) {
    if (!is_denial_[id]) denied_[id].clear();
    std::ranges::sort(denied_[id]);
  }
}

void Denials::look(const clauses::ClauseSet& set, const clauses::Clause& clause) {
  const auto is_name = [&](const Atom& atom) { return set.concepts[atom.predicate].kind == ConceptKind::auxiliary; };
  const bool has_shape =
      clause.head.empty() && clause.body.size() == 2 && std::ranges::all_of(clause.body, [](const Atom& atom) {
        return atom.kind == AtomKind::concept_of && atom.first == centre && atom.predicate != number(clauses::thing);
      });
  // Of two names one could be extended into the other.
  const bool is_denial = has_shape && std::ranges::count_if(clause.body, is_name) == 1;
  for (const Atom& atom : clause.body) {
    if (atom.kind != AtomKind::concept_of || !is_name(atom)) continue;
    if (!is_denial) {
      is_denial_[atom.predicate] = false;
    } else {
      const Atom& other = &atom == &clause.body[0] ? clause.body[1] : clause.body[0];
      denied_[atom.predicate].push_back(other.predicate);
    }
  }
}

}  // namespace geminga::hypertableau
