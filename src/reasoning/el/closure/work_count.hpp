// The work of one thread of a closure, told to the budget in batches, so that counting costs next to nothing.
#ifndef GEMINGA_REASONING_EL_CLOSURE_WORK_COUNT_HPP
#define GEMINGA_REASONING_EL_CLOSURE_WORK_COUNT_HPP

#include <cstddef>
#include <utility>

namespace geminga::el {

/// Counts the premises that rules look at, whether or not they lead to something new. Several premises make one step,
/// so that a step takes about as long as those of the other engines. A spent budget ends the closure as a limit does;
/// its conclusions by then follow. Shared has limits.budget, is_cut_off and is_over_limit. Not thread-safe: each worker
/// has its own.
template <typename Shared>
class WorkCount {
 public:
  explicit WorkCount(Shared& shared) : shared_(shared) {}

  void add(std::size_t premises) {
    waiting_ += premises;
    if (waiting_ >= batch) tell();
  }

 private:
  static constexpr std::size_t premises_per_step = 8;
  static constexpr std::size_t batch = 128 * premises_per_step;

  void tell() {
    const std::size_t steps = std::exchange(waiting_, 0) / premises_per_step;
    if (shared_.limits.budget == nullptr || shared_.limits.budget->spend(steps)) return;
    shared_.is_cut_off = true;
    shared_.is_over_limit = true;
  }

  Shared& shared_;
  std::size_t waiting_ = 0;
};

}  // namespace geminga::el

#endif
