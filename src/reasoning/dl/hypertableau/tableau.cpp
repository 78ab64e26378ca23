// Questions to the search, and the results that are kept for later ones.
#include "reasoning/dl/hypertableau/tableau.hpp"

#include <utility>

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {
namespace {

Answer answer_of(Outcome outcome, const std::string& reason) {
  switch (outcome) {
    case Outcome::model:
      return {Verdict::yes, {}};
    case Outcome::no_model:
      return {Verdict::no, {}};
    case Outcome::unknown:
      break;
  }
  return {Verdict::unknown, reason};
}

}  // namespace

Tableau::Tableau(const owl::Ontology& source, const clauses::ClauseSet& clauses, const QuestionLimits& limits)
    : search_(std::make_unique<Search>(source, clauses, limits)) {}

Tableau::~Tableau() = default;

void Tableau::limit_steps(std::size_t steps) { search_->limit_steps(steps); }

std::size_t Tableau::steps() const { return search_->steps(); }

/// With nominals, the model of the world is also made the base, if it is not the base already. A question that left the
/// base has shown which guesses about the individuals are wrong for it, and probably for others, too. So the world is
/// found again with these records; if that takes too long, without, which has succeeded before.
const Tableau::World& Tableau::find_world() {
  const bool needs_base = search_->has_nominals();
  if (world_ && (world_->answer.verdict != Verdict::yes || !needs_base || search_->has_base())) return *world_;
  search_->reset();
  Outcome outcome = search_->find_world();
  if (world_ && outcome == Outcome::unknown) {
    search_->forget_records();
    search_->reset();
    outcome = search_->find_world();
  }
  std::string reason = search_->reason();
  const bool is_open = outcome == Outcome::unknown && search_->is_open_for_rules();
  if (is_open) outcome = find_world_whatever_is_unknown(reason);
  world_ = World{answer_of(outcome, reason), {}};
  if (outcome == Outcome::model) {
    world_->model = search_->model();
    model_ = world_->model;
    if (needs_base) search_->keep();
  }
  if (is_open && taken_for_true_.empty()) search_->take_unknown_for_true(false);
  return *world_;
}

/// A model in which the heads of rules hold where only the unknown parts of their bodies may not is a model in any
/// case. With nominals it is the base of questions, of which then only a model says something.
Outcome Tableau::find_world_whatever_is_unknown(const std::string& reason) {
  search_->take_unknown_for_true(true);
  if (search_->find_world() != Outcome::model) return Outcome::unknown;
  if (search_->has_nominals()) taken_for_true_ = reason;
  return Outcome::model;
}

Answer Tableau::is_consistent() {
  const World& world = find_world();
  if (world.answer.verdict == Verdict::yes) model_ = world.model;
  return world.answer;
}

/// Without nominals facts do not matter to questions, so the base is empty at first.
void Tableau::prepare_base() {
  if (search_->has_nominals() || (search_->has_base() && !search_->is_base_full())) return;
  forget_all();
  search_->keep();
}

void Tableau::begin_anew() {
  if (!search_->has_nominals()) forget_all();
}

void Tableau::forget_all() {
  search_->forget_records();
  search_->reset();
}

Answer Tableau::is_satisfiable(std::vector<clauses::ConceptId> together,
                               const std::vector<clauses::ConceptId>& outside) {
  const World& world = find_world();
  if (world.answer.verdict != Verdict::yes) return world.answer;
  prepare_base();
  Outcome outcome = search_->find_instance(together, outside);
  // A former question may be to blame.
  const bool is_final = outcome == Outcome::model || (outcome == Outcome::no_model && search_->is_refuted_alone());
  if (!is_final && search_->has_tainted_base()) {
    search_->forget_misleading_base();
    if (const World& pure = find_world(); pure.answer.verdict != Verdict::yes) return pure.answer;
    outcome = search_->find_instance(std::move(together), outside);
  }
  if (outcome == Outcome::model) model_ = search_->model();
  Answer answer = answer_of(outcome, search_->reason());
  if (!taken_for_true_.empty()) {
    model_.certain.clear();
    if (outcome == Outcome::no_model) answer = {Verdict::unknown, taken_for_true_};
  }
  search_->end_question(outcome);
  return answer;
}

}  // namespace geminga::hypertableau
