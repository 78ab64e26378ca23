// The numbers of the predicates and roles of a rule set, as far as the clauses and facts name them.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_PREDICATES_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_PREDICATES_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/consequence/rules/rule.hpp"

namespace geminga::consequence {

/// Fields with the names of those of RuleSet mean the same.
struct Predicates {
  std::uint32_t query_count = 0;
  std::vector<std::uint32_t> predicate_of;
  std::vector<clauses::ConceptId> query_concepts;
  std::vector<std::uint32_t> nominal_of;
  std::uint32_t first_marker = 0;    ///< of the at-leasts, then of the data at-leasts, then of facts
  std::uint32_t first_at_most = 0;   ///< of the at-mosts, then of the data at-mosts
  std::vector<std::uint32_t> range;  ///< of each DataRangeId, then of the values of data facts
  std::uint32_t count = 0;
  std::uint32_t first_data_role = 0;
  std::uint32_t role_count = 0;
  std::uint32_t thing = 0;
  std::uint32_t nothing = 0;

  [[nodiscard]] RuleAtom concept_atom(clauses::ConceptId of, std::uint8_t variable) const {
    return unary_atom(predicate_of[clauses::number(of)], variable);
  }
  [[nodiscard]] RuleAtom nominal_atom(clauses::IndividualId individual, std::uint8_t variable = 0) const {
    return unary_atom(nominal_of[clauses::number(individual)], variable);
  }
  [[nodiscard]] std::uint32_t data_role(clauses::DataPropertyId property) const {
    return first_data_role + clauses::number(property);
  }
};

/// Numbers the predicates of the clauses, and of facts with so many expansions and different values.
[[nodiscard]] Predicates number_predicates(const clauses::ClauseSet& clauses, std::size_t fact_expansions,
                                           std::size_t fact_values);

}  // namespace geminga::consequence

#endif
