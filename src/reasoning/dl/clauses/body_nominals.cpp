// Finds the nominals that something may conclude or ask about. All others are replaced.
#include "reasoning/dl/clauses/body_nominals.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace geminga::clauses {
namespace {

/// By concept: whether it is concluded or asked about.
std::vector<bool> find_concluded(const ClauseSet& set) {
  std::vector<bool> is_concluded(set.concepts.size(), false);
  const auto add = [&](ConceptId of) { is_concluded[number(of)] = true; };
  for (const Clause& clause : set.clauses) {
    for (const Atom& atom : clause.head) {
      if (atom.kind == AtomKind::concept_of) is_concluded[atom.predicate] = true;
    }
  }
  for (const AtLeast& at_least : set.at_leasts) add(at_least.filler);
  for (const ConceptFact& fact : set.concept_facts) add(fact.of);
  for (const Rule& rule : set.rules) {
    for (const RuleAtom& atom : rule.heads) {
      if (atom.kind == RuleAtomKind::concept_of) is_concluded[atom.predicate] = true;
    }
  }
  for (const ConceptId of : set.queries) add(of);
  for (const ConceptId of : set.complements) add(of);
  return is_concluded;
}

}  // namespace

void replace_body_nominals(ClauseSet& set) {
  const std::vector<bool> is_concluded = find_concluded(set);
  for (std::size_t at = 0; at < set.concepts.size(); ++at) {
    Concept& one = set.concepts[at];
    if (one.kind != ConceptKind::nominal || is_concluded[at]) continue;
    set.concept_facts.push_back({ConceptId{static_cast<std::uint32_t>(at)}, one.individual});
    one.kind = ConceptKind::mark;
  }
}

}  // namespace geminga::clauses
