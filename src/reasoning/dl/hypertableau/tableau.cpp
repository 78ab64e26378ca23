// Questions to the search, and the results that are kept for later ones.
#include "reasoning/dl/hypertableau/tableau.hpp"

#include <utility>

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {
namespace {

/// With more nodes than this, the models of earlier questions are forgotten.
constexpr std::size_t max_kept_nodes = 20'000;

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

/// With nominals, the model of the world is also made the base, if it is not the base already.
const Tableau::World& Tableau::find_world() {
  const bool needs_base = search_->has_nominals();
  if (world_ && (world_->answer.verdict != Verdict::yes || !needs_base || search_->has_base())) return *world_;
  search_->reset();
  const Outcome outcome = search_->find_world();
  world_ = World{answer_of(outcome, search_->reason()), {}};
  if (outcome == Outcome::model) {
    world_->model = search_->model();
    model_ = world_->model;
    if (needs_base) search_->keep();
  }
  return *world_;
}

Answer Tableau::is_consistent() {
  const World& world = find_world();
  if (world.answer.verdict == Verdict::yes) model_ = world.model;
  return world.answer;
}

/// Without nominals facts do not matter to questions, so the base is empty at first.
void Tableau::prepare_base() {
  if (search_->has_nominals() || (search_->has_base() && search_->base_node_count() <= max_kept_nodes)) return;
  search_->reset();
  search_->keep();
}

void Tableau::begin_anew() {
  if (!search_->has_nominals()) search_->reset();
}

Answer Tableau::is_satisfiable(std::vector<clauses::ConceptId> together, std::optional<clauses::ConceptId> outside) {
  const World& world = find_world();
  if (world.answer.verdict != Verdict::yes) return world.answer;
  prepare_base();
  const Outcome outcome = search_->find_instance(std::move(together), outside);
  if (outcome == Outcome::model) model_ = search_->model();
  Answer answer = answer_of(outcome, search_->reason());
  search_->end_question(outcome);
  return answer;
}

}  // namespace geminga::hypertableau
