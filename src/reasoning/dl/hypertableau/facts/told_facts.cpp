// Individuals and their facts, equalities last.
#include "reasoning/dl/hypertableau/facts/told_facts.hpp"

#include <cstddef>
#include <cstdint>

namespace geminga::hypertableau {

using clauses::number;

namespace {

void add_individuals(const clauses::ClauseSet& set, const Program& program, Assertions& facts) {
  if (set.individuals.empty()) {
    const NodeId node = facts.add_node(NodeKind::root, none, no_dependency);
    if (!program.needs_thing()) facts.add_fact(FactKind::concept_of, number(clauses::thing), node, 0, no_dependency);
  }
  facts.add_individuals(set.individuals.size(), set.apart);
  for (std::uint32_t at = 0; at < set.concepts.size(); ++at) {
    const clauses::Concept& entry = set.concepts[at];
    if (entry.kind != clauses::ConceptKind::nominal) continue;
    const NodeId node = facts.individuals()[number(entry.individual)];
    facts.add_fact(FactKind::concept_of, at, node, 0, no_dependency);
  }
}

}  // namespace

void assert_told_facts(const clauses::ClauseSet& set, const Program& program, Assertions& facts) {
  add_individuals(set, program, facts);
  const auto node_of = [&](clauses::IndividualId individual) { return facts.individuals()[number(individual)]; };
  for (const clauses::ConceptFact& fact : set.concept_facts) {
    facts.add_fact(FactKind::concept_of, number(fact.of), node_of(fact.individual), 0, no_dependency);
  }
  for (const clauses::RoleFact& fact : set.role_facts) {
    facts.add_fact(FactKind::role, number(fact.property), node_of(fact.first), node_of(fact.second), no_dependency);
  }
  for (const clauses::DataFact& fact : set.data_facts) {
    const NodeId value = facts.constant(fact.value);
    facts.add_fact(FactKind::data_role, number(fact.property), node_of(fact.individual), value, no_dependency);
  }
  for (const clauses::Equality& equality : set.equalities) {
    const NodeId first = node_of(equality.first);
    const NodeId second = node_of(equality.second);
    if (equality.is_negated) {
      facts.add_unequal(first, second, no_dependency);
    } else {
      facts.add_merge(first, second, no_dependency);
    }
  }
}

}  // namespace geminga::hypertableau
