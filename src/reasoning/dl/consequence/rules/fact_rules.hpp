// Facts about individuals, as rules over their nominals.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_FACT_RULES_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_FACT_RULES_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/consequence/rules/centred_rules.hpp"
#include "reasoning/dl/consequence/rules/expansions.hpp"
#include "reasoning/dl/consequence/rules/predicates.hpp"

namespace geminga::consequence {

/// Facts by their individuals and values.
struct GatheredFacts {
  /// The roles between two individuals. Variable 1 is a neighbour of the first.
  std::map<std::pair<std::uint32_t, std::uint32_t>, Atoms> links;
  /// The values of data facts, with their positions behind the data ranges of the clauses.
  std::map<owl::TermId, std::size_t> values;
  std::size_t expansions = 0;  ///< that add_fact_rules() makes
};
[[nodiscard]] GatheredFacts gather_facts(const clauses::ClauseSet& clauses);

/// A longer list of individuals that differ from each other has no rules, which are one for each pair: apart_gap.
inline constexpr std::size_t max_apart = 500;

/// Adds the rules of the facts.
void add_fact_rules(const clauses::ClauseSet& clauses, const GatheredFacts& facts, const Predicates& predicates,
                    Expansions& expansions, CentredRules& rules);

}  // namespace geminga::consequence

#endif
