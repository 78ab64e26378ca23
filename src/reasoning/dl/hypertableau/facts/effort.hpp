// The cost of a question, and its limits.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_EFFORT_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_EFFORT_HPP

#include <cstddef>
#include <string>
#include <utility>

#include "base/budget.hpp"
#include "reasoning/dl/hypertableau/facts/question_limits.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"

namespace geminga::hypertableau {

/// Counts the work for one question against its limits, and keeps why the question cannot be answered.
class Effort {
 public:
  Effort(const QuestionLimits& limits, const Graph& graph) : limits_(limits), budget_(limits.budget), graph_(graph) {}

  /// Begins another question. `is_about_world`: whether the ontology has a model.
  void begin(bool is_about_world) {
    most_steps_ = limits_.steps + (is_about_world ? limits_.world_steps : 0);
    earlier_steps_ += steps_;
    steps_ = told_ = 0;
    reason_.clear();
  }
  /// Nodes and facts below this mark belong to kept models and are not counted.
  void set_base(const Mark& base) { base_ = base; }

  /// Gives each later question so many steps.
  void limit_steps(std::size_t steps) { limits_.steps = steps; }

  void count_step() { ++steps_; }
  void count_steps(std::size_t steps) { steps_ += steps; }
  /// Counts a look at a fact or node that gave nothing new. Several looks are one step.
  void count_look() {
    if (++looked_ % looks_a_step == 0) ++steps_;
  }
  /// Counts looks that the limits of a question leave aside, so that only the budget pays for them and ends them.
  void count_aside(std::size_t looks) { looked_aside_ += looks; }
  /// Of this question.
  [[nodiscard]] std::size_t steps() const { return steps_; }
  /// Of all questions.
  [[nodiscard]] std::size_t all_steps() const { return earlier_steps_ + steps_; }
  /// Whether a limit is passed; if so, that is the reason.
  bool is_over_limit();

  void set_reason(std::string reason) { reason_ = std::move(reason); }
  /// Empty as long as nothing is in the way of an answer.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  static constexpr std::size_t looks_a_step = 16;

  /// The steps that the budget is to be told of now.
  std::size_t untold();

  QuestionLimits limits_;
  base::BudgetUse budget_;
  const Graph& graph_;
  Mark base_;
  std::size_t most_steps_ = 0;
  std::size_t steps_ = 0;
  std::size_t earlier_steps_ = 0;  ///< of earlier questions
  std::size_t looked_ = 0;         ///< looks that are no full step
  std::size_t looked_aside_ = 0;   ///< looks aside that the budget does not know of
  std::size_t told_ = 0;           ///< steps that the budget knows of
  std::string reason_;
};

}  // namespace geminga::hypertableau

#endif
