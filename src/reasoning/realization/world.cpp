#include "reasoning/realization/world.hpp"

#include <algorithm>
#include <utility>

#include "base/sorted.hpp"
#include "reasoning/reasoner/unused.hpp"

namespace geminga::realization {

using clauses::AtomKind;
using clauses::centre;
using clauses::ConceptId;
using clauses::number;

namespace {

/// For each individual or fact. Nodes of individuals and of what they must be related to, facts that are there at once,
/// and steps of the search.
constexpr std::size_t nodes_an_individual = 16;
constexpr std::size_t facts_a_fact = 50;
constexpr std::size_t steps_a_fact = 1000;
constexpr std::size_t steps_an_inequality = 4;

ConceptId add_concept(clauses::ClauseSet& set, owl::TermId term) {
  set.concepts.push_back({clauses::ConceptKind::auxiliary, term, {}});
  return ConceptId{static_cast<std::uint32_t>(set.concepts.size() - 1)};
}

}  // namespace

hypertableau::QuestionLimits limits_for(const clauses::ClauseSet& set, const Options& options) {
  hypertableau::QuestionLimits limits;
  const std::size_t facts =
      set.individuals.size() + set.concept_facts.size() + set.role_facts.size() + set.data_facts.size();
  limits.nodes += nodes_an_individual * set.individuals.size() + set.data_facts.size();
  limits.facts += facts_a_fact * facts + set.equalities.size();
  limits.world_steps = steps_a_fact * facts + steps_an_inequality * set.equalities.size();
  limits.budget = options.budget;
  return limits;
}

void note_unused(const owl::Ontology& source, const clauses::ClauseSet& set, Gaps& gaps) {
  for (const clauses::Unused& entry : set.unused)
    gaps.insert(reasoner::describe_unused(source, entry.axiom, entry.construct));
}

ConceptId add_complement(clauses::ClauseSet& set, ConceptId of) {
  const ConceptId complement = add_concept(set, set.concepts[number(of)].term);
  set.clauses.push_back(
      {{{AtomKind::concept_of, centre, centre, number(of)}, {AtomKind::concept_of, centre, centre, number(complement)}},
       {}});
  return complement;
}

// A(x), R(x,y), B(y) -> false
std::pair<ConceptId, ConceptId> add_unlinked(clauses::ClauseSet& set, clauses::PropertyId property) {
  const ConceptId first = add_concept(set, set.properties[number(property)]);
  const ConceptId second = add_concept(set, set.properties[number(property)]);
  set.clauses.push_back({{{AtomKind::concept_of, centre, centre, number(first)},
                          {AtomKind::concept_of, 1, centre, number(second)},
                          {AtomKind::role, centre, 1, number(property)}},
                         {}});
  return {first, second};
}

void sort_clauses(clauses::ClauseSet& set) { base::sort_unique(set.clauses); }

std::vector<clauses::IndividualId> named_individuals(const owl::Ontology& source, const clauses::ClauseSet& set) {
  std::vector<std::pair<std::string_view, clauses::IndividualId>> named;
  for (std::uint32_t at = 0; at < set.individuals.size(); ++at) {
    const owl::TermId term = set.individuals[at];
    if (term != clauses::no_term && source.kind(term) == owl::TermKind::individual)
      named.emplace_back(source.name_of(term), clauses::IndividualId{at});
  }
  std::ranges::sort(named);
  std::vector<clauses::IndividualId> found;
  found.reserve(named.size());
  for (const auto& [name, individual] : named) found.push_back(individual);
  return found;
}

}  // namespace geminga::realization
