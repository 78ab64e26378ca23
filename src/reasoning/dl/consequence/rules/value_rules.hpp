// Data ranges as rules over the values that are in them.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_VALUE_RULES_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_VALUE_RULES_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/consequence/rules/centred_rules.hpp"
#include "reasoning/dl/consequence/rules/predicates.hpp"

namespace geminga::owl {
class Ontology;
}

namespace geminga::consequence {

/// Properties of the ranges that the rules do not express.
struct UnsaidOfRanges {
  bool is_finite = false;              ///< some range has finitely many values
  std::vector<std::uint32_t> unclear;  ///< predicates of ranges that are not understood
  std::vector<std::string> gaps;
};

/// Adds the rules of the ranges of the clauses and of the values of facts, with their positions behind the ranges.
UnsaidOfRanges add_value_rules(const owl::Ontology& source, const clauses::ClauseSet& clauses,
                               const std::map<owl::TermId, std::size_t>& fact_values, const Predicates& predicates,
                               CentredRules& rules);

}  // namespace geminga::consequence

#endif
