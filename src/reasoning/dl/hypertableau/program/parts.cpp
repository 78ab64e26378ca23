#include "reasoning/dl/hypertableau/program/parts.hpp"

#include <initializer_list>

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::ConceptKind;
using clauses::number;

Parts::Parts(const clauses::ClauseSet& set) : parts_(set.concepts.size()) {
  std::vector<bool> is_whole;  // by concept: its parts are all that follows from it
  for (const clauses::Concept& one : set.concepts) is_whole.push_back(one.kind == ConceptKind::auxiliary);
  for (const clauses::Clause& clause : set.clauses) {
    const bool is_part = clause.body.size() == 1 && clause.head.size() == 1 && clause.head[0].first == centre &&
                         (clause.head[0].kind == AtomKind::concept_of || clause.head[0].kind == AtomKind::at_least);
    for (const Atom& atom : clause.body) {
      if (atom.kind != AtomKind::concept_of) continue;
      if (is_part && atom.first == centre) {
        parts_[atom.predicate].push_back(clause.head[0]);
      } else {
        is_whole[atom.predicate] = false;
      }
    }
  }
  // More instances of these would count, or would be an answer.
  for (const clauses::AtMost& bound : set.at_mosts) is_whole[number(bound.filler)] = false;
  for (const clauses::Key& key : set.keys) is_whole[number(key.of)] = false;
  for (const auto* asked : {&set.queries, &set.complements}) {
    for (const clauses::ConceptId id : *asked) is_whole[number(id)] = false;
  }
  for (const clauses::Rule& rule : set.rules) {
    for (const clauses::RuleAtom& atom : rule.body) {
      if (atom.kind == clauses::RuleAtomKind::concept_of) is_whole[atom.predicate] = false;
    }
  }
  for (std::size_t id = 0; id < parts_.size(); ++id) {
    if (!is_whole[id]) parts_[id].clear();
  }
}

}  // namespace geminga::hypertableau
