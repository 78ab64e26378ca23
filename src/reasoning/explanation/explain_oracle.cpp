// The rules of EL are asked first, then a model that refutes, then the consequences of clauses.
#include "reasoning/explanation/explain_oracle.hpp"

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"

namespace geminga::explanation {
namespace {

using hypertableau::Verdict;

/// The bounds of one question. An explanation asks tens of them, most about a handful of axioms.
struct Bounds {
  hypertableau::QuestionLimits model;
  std::size_t derived_clauses = 0;
  std::size_t undecided = 0;  ///< the most questions that may be too hard
};

Bounds bounds(Patience patience) {
  if (patience == Patience::of_a_person) return {{.nodes = 50'000, .steps = 3'000'000}, 200'000, 16};
  return {{.nodes = 5'000, .steps = 100'000}, 10'000, 3};
}

/// The steps of a budget that an axiom of a question counts for.
constexpr std::uint64_t steps_of_axiom = 10;

}  // namespace

bool Oracle::count(std::size_t work) {
  work_ += work;
  return budget_ == nullptr || budget_->spend(steps_of_axiom * work);
}

el::Entailed Oracle::find_by_rules(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super) {
  if (!count(1 + axioms.size())) return el::Entailed::not_found;
  return el::find_entailed(source_, axioms, sub, super);
}

bool Oracle::holds(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super) {
  const el::Entailed by_rules = find_by_rules(axioms, sub, super);
  if (by_rules != el::Entailed::not_found) return by_rules == el::Entailed::yes;
  if (undecided_ >= bounds(patience_).undecided) return false;
  const Decision decision = decide_by_models(axioms, sub, super);
  if (decision.is_too_hard) ++undecided_;
  return decision.verdict == Verdict::yes;
}

Oracle::Decision Oracle::decide(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super) {
  const el::Entailed by_rules = find_by_rules(axioms, sub, super);
  if (by_rules == el::Entailed::not_found) return decide_by_models(axioms, sub, super);
  return {.verdict = by_rules == el::Entailed::yes ? Verdict::yes : Verdict::no};
}

Oracle::Decision Oracle::decide_by_models(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super) {
  const Bounds limits = bounds(patience_);
  // These engines need about ten times as long as the rules.
  if (!count(10 * axioms.size())) return {.reason = budget_->reason().value_or(""), .is_too_hard = true};
  const auto clauses = clauses::clausify(source_, axioms, std::span(&sub, 1), std::span(&super, 1));
  if (!clauses) return {.reason = clauses.error().text, .is_too_hard = true};
  hypertableau::Tableau tableau(source_, *clauses, limits.model);
  const hypertableau::Answer exception =
      tableau.is_satisfiable({clauses->queries.front(), clauses->complements.front()});
  if (exception.verdict == Verdict::no) return {.verdict = Verdict::yes};
  if (exception.verdict == Verdict::yes) {
    if (clauses->unused.empty()) return {.verdict = Verdict::no};
    return {.reason = "an axiom cannot be used because of " + std::string(clauses->unused.front().construct)};
  }
  if (consequence::derives(source_, *clauses, super, {.clauses = limits.derived_clauses}))
    return {.verdict = Verdict::yes};
  return {.reason = exception.reason, .is_too_hard = true};
}

}  // namespace geminga::explanation
