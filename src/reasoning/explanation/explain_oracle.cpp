// The rules of EL are asked first. Then consequences are derived and models built in turns.
#include "reasoning/explanation/explain_oracle.hpp"

#include <algorithm>
#include <utility>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"

namespace geminga::explanation {
namespace {

using consequence::Derived;
using hypertableau::Verdict;

/// The bounds of one question. An explanation asks tens of them, most about a handful of axioms.
struct Bounds {
  std::size_t clauses = 0;  ///< that are derived
  hypertableau::QuestionLimits model;
  std::size_t undecided = 0;  ///< the most questions that may be too hard
};

Bounds bounds(Patience patience) {
  if (patience == Patience::of_a_person) return {200'000, {.nodes = 50'000, .steps = 3'000'000}, 16};
  return {10'000, {.nodes = 5'000, .steps = 100'000}, 3};
}

/// A subset of an ontology may be hard for one engine and easy for the other. Neither is known before. So both take
/// turns with bounds that grow, and together they take a few times as long as the faster of the two alone.
constexpr std::size_t first_clauses = 1'000;
constexpr std::size_t growth_a_turn = 4;
/// The steps of a model that take the time of a derived clause.
constexpr std::size_t steps_a_clause = 8;

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
  const Decision decision = decide_beyond_rules(axioms, sub, super);
  if (decision.is_too_hard) ++undecided_;
  return decision.verdict == Verdict::yes;
}

Oracle::Decision Oracle::decide(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super) {
  const el::Entailed by_rules = find_by_rules(axioms, sub, super);
  if (by_rules == el::Entailed::not_found) return decide_beyond_rules(axioms, sub, super);
  return {.verdict = by_rules == el::Entailed::yes ? Verdict::yes : Verdict::no};
}

/// The next question is often alike. So the engine that decided the last one begins, with the bound that was enough. A
/// question that was too hard says nothing of the next one, which begins small.
Oracle::Decision Oracle::decide_beyond_rules(std::span<const std::uint32_t> axioms, owl::TermId sub,
                                             owl::TermId super) {
  // These engines need about ten times as long as the rules.
  if (!count(10 * axioms.size())) return {.reason = budget_->reason().value_or(""), .is_too_hard = true};
  const auto clauses = clauses::clausify(source_, axioms, std::span(&sub, 1), std::span(&super, 1));
  if (!clauses) return {.reason = clauses.error().text, .is_too_hard = true};
  const Bounds most = bounds(patience_);
  bool is_open = false;  // more clauses would not decide it
  std::string reason;
  const auto derive = [&](std::size_t turn) {
    if (is_open) return Verdict::unknown;
    const Derived derived =
        consequence::derives(source_, *clauses, super, {.clauses = std::min(turn, most.clauses), .budget = budget_});
    is_open = derived == Derived::open;
    return derived == Derived::yes ? Verdict::yes : derived == Derived::no ? Verdict::no : Verdict::unknown;
  };
  const auto build = [&](std::size_t turn) {
    hypertableau::QuestionLimits limits = most.model;
    if (turn < most.clauses) limits.steps = std::min(limits.steps, steps_a_clause * turn);
    limits.budget = budget_;
    hypertableau::Tableau tableau(source_, *clauses, limits);
    hypertableau::Answer exception = tableau.is_satisfiable({clauses->queries.front(), clauses->complements.front()});
    reason = std::move(exception.reason);
    return exception.verdict == Verdict::yes  ? Verdict::no
           : exception.verdict == Verdict::no ? Verdict::yes
                                              : Verdict::unknown;
  };
  Verdict verdict = Verdict::unknown;
  for (std::size_t turn = std::max(first_clauses, first_turn_); verdict == Verdict::unknown; turn *= growth_a_turn) {
    first_turn_ = turn;
    verdict = derives_first_ ? derive(turn) : build(turn);
    if (verdict != Verdict::unknown) break;
    verdict = derives_first_ ? build(turn) : derive(turn);
    if (verdict != Verdict::unknown) {
      derives_first_ = !derives_first_;
    } else if (turn >= most.clauses || is_spent()) {
      first_turn_ = 0;
      return {.reason = std::move(reason), .is_too_hard = true};
    }
  }
  if (verdict == Verdict::yes || clauses->unused.empty()) return {.verdict = verdict};
  return {.reason = "an axiom cannot be used because of " + std::string(clauses->unused.front().construct)};
}

}  // namespace geminga::explanation
