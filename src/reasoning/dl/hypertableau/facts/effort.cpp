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
  } else if (const std::size_t told = std::exchange(told_, steps_); !budget_.spend(steps_ - told)) {
    reason_ = limits_.budget->reason().value_or("");
  } else {
    return false;
  }
  return true;
}

}  // namespace geminga::hypertableau
