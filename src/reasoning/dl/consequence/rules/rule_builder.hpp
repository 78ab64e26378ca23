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

/// At-leasts that need more successors make only so many, and are a gap.
inline constexpr std::uint32_t max_successors = 64;
/// The most pairs of an at-least and a greater at-most of which a rule says that they exclude each other.
inline constexpr std::size_t max_exclusive_numbers = 100'000;

/// The rules of the clauses and, `with_facts`, of the facts about individuals. Gaps are named.
[[nodiscard]] RuleSet build_rules(const owl::Ontology& source, const clauses::ClauseSet& clauses, bool with_facts);

}  // namespace geminga::consequence

#endif
