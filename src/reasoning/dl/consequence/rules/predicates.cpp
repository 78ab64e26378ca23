#include "reasoning/dl/consequence/rules/predicates.hpp"

namespace geminga::consequence {

using clauses::number;

Predicates number_predicates(const clauses::ClauseSet& clauses, std::size_t fact_expansions, std::size_t fact_values) {
  Predicates result;
  result.predicate_of.resize(clauses.concepts.size());
  std::uint32_t next = 0;
  for (const bool is_query : {true, false}) {
    for (std::size_t i = 0; i < clauses.concepts.size(); ++i) {
      if ((clauses.concepts[i].kind != clauses::ConceptKind::auxiliary) != is_query) continue;
      result.predicate_of[i] = next++;
      if (is_query) result.query_concepts.push_back(clauses::ConceptId{static_cast<std::uint32_t>(i)});
    }
    if (is_query) result.query_count = next;
  }
  result.thing = result.predicate_of[number(clauses::thing)];
  result.nothing = result.predicate_of[number(clauses::nothing)];
  constexpr std::uint32_t none = 0xffffffffU;
  result.nominal_of.assign(clauses.individuals.size(), none);
  for (std::size_t i = 0; i < clauses.concepts.size(); ++i) {
    if (clauses.concepts[i].kind != clauses::ConceptKind::nominal) continue;
    result.nominal_of[number(clauses.concepts[i].individual)] = result.predicate_of[i];
  }
  for (std::uint32_t& nominal : result.nominal_of) {
    if (nominal == none) nominal = next++;
  }
  result.first_marker = next;
  next += static_cast<std::uint32_t>(clauses.at_leasts.size() + clauses.data_at_leasts.size() + fact_expansions);
  result.first_at_most = next;
  next += static_cast<std::uint32_t>(clauses.at_mosts.size() + clauses.data_at_mosts.size());
  for (std::size_t i = 0; i < clauses.data_ranges.size() + fact_values; ++i) result.range.push_back(next++);
  result.count = next;
  result.first_data_role = static_cast<std::uint32_t>(clauses.properties.size());
  result.role_count = result.first_data_role + static_cast<std::uint32_t>(clauses.data_properties.size());
  return result;
}

}  // namespace geminga::consequence
