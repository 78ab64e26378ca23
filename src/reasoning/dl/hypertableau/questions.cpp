// How questions are put to the search.
#include "reasoning/dl/hypertableau/questions.hpp"

#include <utility>

namespace geminga::hypertableau {
namespace {

/// Beyond this the models of earlier questions make room.
constexpr std::size_t max_kept_nodes = 20'000;

Answer answer(Outcome outcome, const std::string& reason) {
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

const Questions::World& Questions::find_world() {
  const bool needs_base = search_.has_nominals();
  if (world_ && (world_->outcome != Outcome::model || !needs_base || search_.has_base())) return *world_;
  search_.reset();
  const Outcome outcome = search_.find_world();
  world_ = World{outcome, search_.reason(), {}};
  if (outcome == Outcome::model) {
    world_->model = search_.model();
    model_ = world_->model;
    if (needs_base) search_.keep();
  }
  return *world_;
}

Answer Questions::is_consistent() {
  const World& world = find_world();
  if (world.outcome == Outcome::model) model_ = world.model;
  return answer(world.outcome, world.reason);
}

// Without nominals facts and questions have nothing to do with each other.
void Questions::prepare_base() {
  if (search_.has_nominals() || (search_.has_base() && search_.base_node_count() <= max_kept_nodes)) return;
  search_.reset();
  search_.keep();
}

Answer Questions::is_satisfiable(std::vector<clauses::ConceptId> together) {
  const World& world = find_world();
  if (world.outcome != Outcome::model) return answer(world.outcome, world.reason);
  prepare_base();
  const Outcome outcome = search_.find_instance(std::move(together));
  if (outcome == Outcome::model) model_ = search_.model();
  Answer result = answer(outcome, search_.reason());
  search_.end_question(outcome);
  return result;
}

}  // namespace geminga::hypertableau
