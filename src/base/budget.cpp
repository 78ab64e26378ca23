#include "base/budget.hpp"

namespace geminga::base {

bool Budget::spend(std::uint64_t steps) {
  if (is_spent()) return false;
  const std::uint64_t spent = spent_.fetch_add(steps, std::memory_order_relaxed) + steps;
  End open = End::open;
  if (spent > steps_) {
    end_.compare_exchange_strong(open, End::steps);
    return false;
  }
  if (!is_over_) return true;
  std::uint64_t next = next_question_.load(std::memory_order_relaxed);
  // One of the threads that pass the mark asks.
  if (spent < next || !next_question_.compare_exchange_strong(next, spent + between_)) return true;
  if (!is_over_()) return true;
  end_.compare_exchange_strong(open, End::time);
  return false;
}

std::optional<std::string> Budget::reason() const {
  switch (end_.load()) {
    case End::open:
      return std::nullopt;
    case End::steps:
      return "the limit of " + std::to_string(steps_) + " steps was reached";
    case End::time:
      return "the time limit was reached";
  }
  return std::nullopt;
}

}  // namespace geminga::base
