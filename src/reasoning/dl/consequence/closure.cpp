#include "reasoning/dl/consequence/closure.hpp"

#include <algorithm>

#include "base/sorted.hpp"
#include "reasoning/dl/consequence/rules/rule_builder.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"
#include "reasoning/dl/consequence/saturation.hpp"
#include "reasoning/dl/consequence/settled_contexts.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::consequence {
namespace {

using clauses::ConceptId;
using clauses::number;

[[nodiscard]] ContextKey key_of(const RuleSet& vocabulary, ConceptId wanted) {
  ContextKey key;
  if (wanted != clauses::thing) key.core.push_back(unary(vocabulary.predicate_of[number(wanted)], x_term));
  return key;
}

[[nodiscard]] std::vector<ConceptId> subsumers_of(const RuleSet& vocabulary, const Context& context, ConceptId wanted) {
  if (context.is_unsatisfiable) return {clauses::nothing};
  std::vector<ConceptId> found{clauses::thing, wanted};
  context.store.for_each_unit([&](Literal literal) {
    if (literal.term() != x_term || literal.kind() != LiteralKind::unary) return;
    if (literal.predicate() < vocabulary.query_count) found.push_back(vocabulary.query_concepts[literal.predicate()]);
  });
  base::sort_unique(found);
  return found;
}

}  // namespace

Closure saturate(const owl::Ontology& source, const clauses::ClauseSet& clauses, std::span<const ConceptId> wanted,
                 const Options& options) {
  const Rules rules(build_rules(source, clauses, options.facts));
  const RuleSet& vocabulary = rules.vocabulary();
  std::vector<std::uint32_t> wanted_predicates;
  for (const ConceptId asked : wanted) wanted_predicates.push_back(vocabulary.predicate_of[number(asked)]);
  Saturation saturation(rules, wanted_predicates,
                        {.clauses = options.clauses, .alternatives = options.alternatives, .budget = options.budget});
  const ArenaUse use(saturation.arena());
  // There is some thing, and there is each individual.
  saturation.assert_existence({});
  if (options.facts) {
    for (const std::uint32_t nominal : vocabulary.nominal_of) saturation.assert_existence({{unary(nominal, x_term)}});
  }
  for (const ConceptId asked : wanted) {
    if (asked != clauses::nothing) saturation.ask(key_of(vocabulary, asked));
  }
  saturation.run(std::max(1U, options.threads));

  const SharedEffort& effort = saturation.effort();
  Closure closure;
  closure.gaps = vocabulary.gaps;
  closure.is_cut_off = effort.is_cut_off() && !effort.is_contradictory();
  if (closure.is_cut_off) {
    const auto spent = options.budget == nullptr ? std::nullopt : options.budget->reason();
    const std::string most = effort.is_flooded()
                                 ? std::to_string(effort.max_messages()) + " messages between contexts waited"
                                 : std::to_string(options.clauses) + " clauses were derived";
    closure.gaps.push_back(spent ? *spent : "more than " + most);
  }
  if (effort.has_cut_context() && !effort.is_contradictory()) closure.gaps.emplace_back(alternative_gap);
  base::sort_unique(closure.gaps);
  closure.contexts = saturation.contexts().size();
  closure.derived = effort.clause_count();
  closure.is_consistent = !effort.is_contradictory();
  const SettledContexts settled(saturation, closure.gaps);
  for (const ConceptId asked : wanted) {
    if (!closure.is_consistent || asked == clauses::nothing) {
      closure.subsumers.push_back({clauses::nothing});
      closure.is_settled.push_back(true);
      closure.is_plain.push_back(false);
      continue;
    }
    const Context& context = *saturation.contexts().find(key_of(vocabulary, asked));
    closure.subsumers.push_back(subsumers_of(vocabulary, context, asked));
    closure.is_settled.push_back(settled.is_settled(context));
    closure.is_plain.push_back(settled.is_settled(context) && !context.is_unsatisfiable &&
                               !context.store.has_alternatives());
  }
  return closure;
}

/// A closure without gaps has every named class above the query that is in a body; the complement of `super` puts it
/// into one. Whether the facts have a model is among what it decides.
Derived derives(const owl::Ontology& source, const clauses::ClauseSet& clauses, owl::TermId super,
                const Options& options) {
  const Closure closure = saturate(source, clauses, clauses.queries, options);
  if (!closure.is_consistent) return Derived::yes;
  const bool follows = std::ranges::any_of(closure.subsumers.front(), [&](ConceptId above) {
    const clauses::Concept& found = clauses.concepts[clauses::number(above)];
    return above == clauses::nothing || (found.kind == clauses::ConceptKind::named && found.term == super);
  });
  if (follows) return Derived::yes;
  if (closure.is_cut_off) return Derived::cut_off;
  return closure.gaps.empty() && source.kind(super) == owl::TermKind::named_class ? Derived::no : Derived::open;
}

}  // namespace geminga::consequence
