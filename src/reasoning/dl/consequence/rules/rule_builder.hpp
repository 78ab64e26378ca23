// From the clauses and facts of an ontology to the rules of the calculus.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_RULE_BUILDER_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_RULE_BUILDER_HPP

#include <cstdint>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/consequence/rules/rule.hpp"

namespace geminga::owl {
class Ontology;
}

namespace geminga::consequence {

/// At-mosts with a greater number are left out and named, because their rules would have so many variables.
inline constexpr std::uint32_t max_at_most = 64;

/// The rules of the clauses and, `with_facts`, of the facts about individuals. Gaps are named.
[[nodiscard]] RuleSet build_rules(const owl::Ontology& source, const clauses::ClauseSet& clauses, bool with_facts);

}  // namespace geminga::consequence

#endif
