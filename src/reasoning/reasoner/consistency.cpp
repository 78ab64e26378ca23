// Whether an ontology has a model.
#include <optional>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/reasoner/unused.hpp"

namespace geminga::reasoner {
namespace {

/// Derived before a model is looked for: with many axioms a model may take long where few clauses decide.
constexpr std::size_t first_clauses_of_the_world = 20'000;
constexpr std::size_t max_clauses_of_the_world = 2'000'000;

}  // namespace

Answer is_consistent(const owl::Ontology& source, base::Budget* budget) {
  if (source.problem()) return {Verdict::unknown, *source.problem()};
  if (const auto found = el::classify(source, {.budget = budget})) {
    if (!found->is_consistent) return {Verdict::no, {}};
    if (found->is_cut_off) return {Verdict::unknown, *budget->reason()};
    if (found->unused.empty()) return {Verdict::yes, {}};
  }
  const auto clauses = clauses::clausify(source, std::nullopt, {}, {}, {.budget = budget});
  if (!clauses) return {Verdict::unknown, clauses.error().text};
  const auto derive = [&](std::size_t clause_limit) {
    const consequence::Closure closure =
        consequence::saturate(source, *clauses, {}, {.threads = 1, .clauses = clause_limit, .budget = budget});
    if (!closure.is_consistent) return Verdict::no;
    return closure.gaps.empty() ? Verdict::yes : Verdict::unknown;
  };
  Answer answer{derive(first_clauses_of_the_world), {}};
  if (answer.verdict == Verdict::unknown)
    answer = hypertableau::Tableau(source, *clauses, {.budget = budget}).is_consistent();
  if (answer.verdict == Verdict::unknown) {
    if (const Verdict derived = derive(max_clauses_of_the_world); derived != Verdict::unknown) answer = {derived, {}};
  }
  if (answer.verdict == Verdict::yes && !clauses->unused.empty())
    return {Verdict::unknown,
            describe_unused(source, clauses->unused.front().axiom, clauses->unused.front().construct)};
  return answer;
}

}  // namespace geminga::reasoner
