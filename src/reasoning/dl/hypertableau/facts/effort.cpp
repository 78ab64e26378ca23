// The limits of a question, one after the other.
#include "reasoning/dl/hypertableau/facts/effort.hpp"

namespace geminga::hypertableau {

bool Effort::is_over_limit() {
  if (graph_.node_count() - base_.nodes > limits_.nodes) {
    reason_ = "more than " + std::to_string(limits_.nodes) + " nodes were needed";
  } else if (graph_.facts().size() - base_.facts > limits_.facts) {
    reason_ = "more than " + std::to_string(limits_.facts) + " facts were needed";
  } else if (steps_ > most_steps_) {
    reason_ = "more than " + std::to_string(most_steps_) + " steps were needed";
  } else if (!budget_.spend(untold())) {
    reason_ = limits_.budget->reason().value_or("");
  } else {
    return false;
  }
  return true;
}

std::size_t Effort::untold() {
  const std::size_t aside = looked_aside_ / looks_a_step;
  looked_aside_ %= looks_a_step;
  return steps_ - std::exchange(told_, steps_) + aside;
}

}  // namespace geminga::hypertableau
