#include "reasoning/dl/consequence/rules/fact_rules.hpp"

namespace geminga::consequence {

using clauses::number;

GatheredFacts gather_facts(const clauses::ClauseSet& clauses) {
  GatheredFacts facts;
  for (const clauses::RoleFact& fact : clauses.role_facts) {
    if (fact.first == fact.second) continue;
    const std::uint32_t role = number(fact.property);
    facts.links[{number(fact.first), number(fact.second)}].push_back({LiteralKind::outgoing, 1, 0, role});
    facts.links[{number(fact.second), number(fact.first)}].push_back({LiteralKind::incoming, 1, 0, role});
  }
  for (const clauses::DataFact& fact : clauses.data_facts) {
    facts.values.try_emplace(fact.value, clauses.data_ranges.size() + facts.values.size());
  }
  facts.expansions = facts.links.size() + clauses.data_facts.size();
  return facts;
}

//  B(a)             becomes  {a} < B
//  R(a,b), S(b,a)   become   {a} < some (R and S-).{b}  and  {b} < some (R- and S).{a}
//  R(a,a)           becomes  {a} < R Self
//  U(a,v)           becomes  {a} < some U.{v}
//  a = b            becomes  {a} < {b}  and  {b} < {a}
//  a is not b       becomes  {a} and {b} < F
// Everything between two individuals is one successor, so that their roles meet there.
void add_fact_rules(const clauses::ClauseSet& clauses, const GatheredFacts& facts, const Predicates& predicates,
                    Expansions& expansions, CentredRules& rules) {
  const auto nominal = [&](clauses::IndividualId individual) { return predicates.nominal_atom(individual); };
  for (const clauses::ConceptFact& fact : clauses.concept_facts) {
    if (fact.of == clauses::thing) continue;
    rules.add({nominal(fact.individual)},
              fact.of == clauses::nothing ? Atoms{} : Atoms{predicates.concept_atom(fact.of, 0)});
  }
  for (const clauses::RoleFact& fact : clauses.role_facts) {
    if (fact.first == fact.second) {
      rules.add({nominal(fact.first)}, {{LiteralKind::reflexive, 0, 0, number(fact.property)}});
    }
  }
  for (const auto& [pair, roles] : facts.links) {
    Atoms atoms = roles;
    atoms.push_back(predicates.nominal_atom(clauses::IndividualId{pair.second}, 1));
    const std::uint32_t marker = expansions.add(1, std::move(atoms));
    rules.add({nominal(clauses::IndividualId{pair.first})}, {unary_atom(marker)});
  }
  for (const clauses::DataFact& fact : clauses.data_facts) {
    const std::uint32_t marker = expansions.add(1, {{LiteralKind::outgoing, 1, 0, predicates.data_role(fact.property)},
                                                    unary_atom(predicates.range[facts.values.at(fact.value)], 1)});
    rules.add({nominal(fact.individual)}, {unary_atom(marker)});
  }
  for (const clauses::Equality& equality : clauses.equalities) {
    if (equality.is_negated) {
      rules.add({nominal(equality.first), nominal(equality.second)}, {});
    } else {
      rules.add({nominal(equality.first)}, {nominal(equality.second)});
      rules.add({nominal(equality.second)}, {nominal(equality.first)});
    }
  }
  if (clauses.apart.size() > max_apart) return;
  for (std::size_t first = 0; first < clauses.apart.size(); ++first) {
    for (std::size_t second = first + 1; second < clauses.apart.size(); ++second)
      rules.add({nominal(clauses.apart[first]), nominal(clauses.apart[second])}, {});
  }
}

}  // namespace geminga::consequence
