#include "reasoning/dl/hypertableau/program/denials.hpp"

#include <algorithm>
#include <utility>

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::ConceptKind;
using clauses::number;

namespace {

constexpr clauses::Variable beside = 1;

// Whether it speaks of a node and one neighbour.
bool is_of_pair(const Atom& atom) {
  if (atom.kind == AtomKind::concept_of) return atom.first <= beside && atom.predicate != number(clauses::thing);
  return atom.kind == AtomKind::role && atom.first != atom.second && std::max(atom.first, atom.second) == beside;
}

}  // namespace

Denials::Denials(const clauses::ClauseSet& set) : denied_(set.concepts.size()), forbidden_(set.concepts.size()) {
  for (const clauses::Concept& one : set.concepts) is_denial_.push_back(one.kind == ConceptKind::auxiliary);
  for (const clauses::Clause& clause : set.clauses) look(set, clause);
  // More instances of these would count.
  for (const clauses::AtMost& bound : set.at_mosts) is_denial_[number(bound.filler)] = false;
  for (const clauses::Key& key : set.keys) is_denial_[number(key.of)] = false;
  for (std::uint32_t id = 0; id < denied_.size(); ++id) {
    if (!is_denial_[id]) denied_[id].clear();
    if (!is_denial_[id]) forbidden_[id].clear();
    std::ranges::sort(denied_[id]);
  }
}

bool Denials::look_around() const {
  const auto has_roles = [](const Forbidden& all) { return !all.roles.empty(); };
  return std::ranges::any_of(forbidden_, [&](const auto& of_one) { return std::ranges::any_of(of_one, has_roles); });
}

void Denials::look(const clauses::ClauseSet& set, const clauses::Clause& clause) {
  const auto is_name = [&](const Atom& atom) {
    return atom.kind == AtomKind::concept_of && set.concepts[atom.predicate].kind == ConceptKind::auxiliary;
  };
  const auto name = std::ranges::find_if(clause.body, is_name);
  if (name == clause.body.end()) return;
  // Of two names one could be extended into the other.
  const bool is_denial = clause.head.empty() && clause.body.size() > 1 &&
                         std::ranges::all_of(clause.body, is_of_pair) &&
                         std::ranges::count_if(clause.body, is_name) == 1 && name->first == centre;
  if (is_denial) return add(name->predicate, clause);
  for (const Atom& atom : clause.body) {
    if (is_name(atom)) is_denial_[atom.predicate] = false;
  }
}

void Denials::add(std::uint32_t id, const clauses::Clause& clause) {
  Forbidden all;
  for (const Atom& atom : clause.body) {
    if (atom.kind == AtomKind::role) {
      all.roles.push_back(atom);
    } else if (atom.first == beside) {
      all.neighbour_concepts.push_back(atom.predicate);
    } else if (atom.predicate != id) {
      all.concepts.push_back(atom.predicate);
    }
  }
  if (all.roles.empty() && !all.neighbour_concepts.empty()) {
    is_denial_[id] = false;  // the neighbour could be anything
  } else if (all.roles.empty() && all.concepts.size() == 1) {
    denied_[id].push_back(all.concepts.front());
  } else {
    forbidden_[id].push_back(std::move(all));
  }
}

}  // namespace geminga::hypertableau
