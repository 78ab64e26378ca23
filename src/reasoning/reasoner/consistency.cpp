// Whether an ontology has a model.
#include <optional>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/reasoner/unused.hpp"

namespace geminga::reasoner {
namespace {

constexpr std::size_t max_clauses_of_the_world = 2'000'000;

}  // namespace

Answer is_consistent(const owl::Ontology& source, base::Budget* budget) {
  if (source.problem()) return {Verdict::unknown, *source.problem()};
  if (const auto found = el::classify(source, {.budget = budget})) {
    if (!found->is_consistent) return {Verdict::no, {}};
    if (found->is_cut_off) return {Verdict::unknown, *budget->reason()};
    if (found->unused.empty()) return {Verdict::yes, {}};
  }
  const auto clauses = clauses::clausify(source, std::nullopt, {});
  if (!clauses) return {Verdict::unknown, clauses.error().text};
  hypertableau::Tableau tableau(source, *clauses, {.budget = budget});
  Answer answer = tableau.is_consistent();
  if (answer.verdict == Verdict::unknown) {
    const consequence::Closure closure = consequence::saturate(
        source, *clauses, {}, {.threads = 1, .clauses = max_clauses_of_the_world, .budget = budget});
    if (!closure.is_consistent) return {Verdict::no, {}};
    if (closure.gaps.empty()) answer = {Verdict::yes, {}};
  }
  if (answer.verdict == Verdict::yes && !clauses->unused.empty())
    return {Verdict::unknown,
            describe_unused(source, clauses->unused.front().axiom, clauses->unused.front().construct)};
  return answer;
}

}  // namespace geminga::reasoner
