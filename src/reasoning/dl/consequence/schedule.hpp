// The contexts that have messages, on one stack for each thread, and the threads that take them.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_SCHEDULE_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_SCHEDULE_HPP

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "base/arena.hpp"
#include "reasoning/dl/consequence/mailbox.hpp"

namespace geminga::consequence {

/// A context stands on one stack at most, and one thread works on it. A lock is held for a few instructions. The work
/// ends when no context is scheduled.
class Schedule {
 public:
  Schedule() : threads_(1) {}

  /// At least one stack. Not while threads work.
  void set_threads(unsigned threads) {
    while (threads_.size() < threads) threads_.emplace_back();
  }
  /// The memory of a thread's contexts.
  [[nodiscard]] base::Arena& arena(unsigned thread) { return threads_[thread].arena; }
  /// Puts a context onto the stack of this thread.
  void add(Context& context, unsigned thread);

  /// Calls `work` with a context from this thread's stack or another's, until none is scheduled.
  template <typename Work>
  void run(unsigned thread, Work&& work) {
    while (true) {
      const std::uint32_t epoch = epoch_.load();
      if (is_abandoned_.load()) break;
      if (Context* const context = take(thread); context != nullptr) {
        work(*context);
        // The contexts that this one scheduled were counted before the count falls, so it is 0 only at the end.
        if (scheduled_.fetch_sub(1, std::memory_order_acq_rel) == 1) break;
        continue;
      }
      if (scheduled_.load(std::memory_order_acquire) == 0) break;
      sleepers_.fetch_add(1);
      epoch_.wait(epoch);
      sleepers_.fetch_sub(1);
    }
    wake_all();
  }
  /// Ends run() in all threads, whatever is scheduled.
  void abandon() {
    is_abandoned_.store(true);
    wake_all();
  }

 private:
  struct Thread {
    SpinLock lock;
    std::vector<Context*> contexts;  ///< guarded by the lock
    base::Arena arena;               ///< used by its thread alone
  };

  [[nodiscard]] Context* take(unsigned thread);
  void wake_all() {
    epoch_.fetch_add(1);
    epoch_.notify_all();
  }

  std::deque<Thread> threads_;
  std::atomic<std::size_t> scheduled_{0};
  std::atomic<std::uint32_t> epoch_{0};  ///< changes when a sleeper must look again
  std::atomic<std::uint32_t> sleepers_{0};
  std::atomic<bool> is_abandoned_{false};
};

}  // namespace geminga::consequence

#endif
