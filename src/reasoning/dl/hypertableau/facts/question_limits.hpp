// How much work a question may be.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_QUESTION_LIMITS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_QUESTION_LIMITS_HPP

#include <cstddef>

#include "base/budget.hpp"

namespace geminga::hypertableau {

/// Work is counted, never timed, so that the same question has the same answer everywhere.
struct QuestionLimits {
  std::size_t nodes = 100'000;
  /// Facts derived, alternatives and matches looked at, nodes looked at for blocking, over all branches.
  std::size_t steps = 20'000'000;
  std::size_t world_steps = 0;  ///< further steps for the question whether the ontology has a model
  /// False: makes every neighbour that an at-least asks for, and compares no numbers. Answers are the same, and later:
  /// a second opinion.
  bool counts = true;
  std::size_t facts = 4'000'000;  ///< that are there at once, so that memory is bounded: about 50 octets each
  /// A budget that pays for the steps of all questions and for other work. Without it only the limits above hold.
  /// Borrowed.
  base::Budget* budget = nullptr;
};

}  // namespace geminga::hypertableau

#endif
