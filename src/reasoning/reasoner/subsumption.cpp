// One subsumption from some axioms: the question behind explanations, which is asked often and about few axioms.
#include <numeric>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/el/entailment.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/reasoner/unused.hpp"

namespace geminga::reasoner {
namespace {

using consequence::Derived;

/// Derived before a model is looked for: with many axioms a model may take long where few clauses decide.
constexpr std::size_t first_clauses_of_a_question = 20'000;
constexpr std::size_t max_clauses_of_a_question = 500'000;
constexpr std::uint32_t max_expression_levels = 500;  // as SourceLimits::nesting, of expressions that are in no axiom

bool is_subsumed_in_el(const owl::Ontology& source, std::optional<std::span<const std::uint32_t>> axioms,
                       owl::TermId sub, owl::TermId super) {
  if (source.kind(sub) != owl::TermKind::named_class || source.kind(super) != owl::TermKind::named_class) return false;
  if (axioms) return el::entails(source, *axioms, sub, super);
  std::vector<std::uint32_t> all(source.axiom_count());
  std::iota(all.begin(), all.end(), 0U);
  return el::entails(source, all, sub, super);
}

}  // namespace

Answer entails(const owl::Ontology& source, std::optional<std::span<const std::uint32_t>> axioms, owl::TermId sub,
               owl::TermId super, base::Budget* budget) {
  if (source.problem()) return {Verdict::unknown, *source.problem()};
  if (source.depth(sub) > max_expression_levels || source.depth(super) > max_expression_levels)
    return {Verdict::unknown, "an expression nests over " + std::to_string(max_expression_levels) + " levels"};
  if (is_subsumed_in_el(source, axioms, sub, super)) return {Verdict::yes, {}};
  const auto clauses = clauses::clausify(source, axioms, std::span(&sub, 1), std::span(&super, 1), {.budget = budget});
  if (!clauses) return {Verdict::unknown, clauses.error().text};
  const auto answer = [&](bool is_entailed) -> Answer {
    if (is_entailed) return {Verdict::yes, {}};
    if (clauses->unused.empty()) return {Verdict::no, {}};
    return {Verdict::unknown,
            describe_unused(source, clauses->unused.front().axiom, clauses->unused.front().construct)};
  };
  const auto derive = [&](std::size_t clause_limit) {
    return consequence::derives(source, *clauses, super, {.clauses = clause_limit, .budget = budget});
  };
  const auto is_decided = [](Derived derived) { return derived == Derived::yes || derived == Derived::no; };
  const Derived first = derive(first_clauses_of_a_question);
  if (is_decided(first)) return answer(first == Derived::yes);
  Answer counterexample = hypertableau::Tableau(source, *clauses, {.budget = budget})
                              .is_satisfiable({clauses->queries.front(), clauses->complements.front()});
  if (counterexample.verdict != Verdict::unknown) return answer(counterexample.verdict == Verdict::no);
  if (first == Derived::open) return counterexample;
  if (const Derived all = derive(max_clauses_of_a_question); is_decided(all)) return answer(all == Derived::yes);
  return counterexample;
}

}  // namespace geminga::reasoner
