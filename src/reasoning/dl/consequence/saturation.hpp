// The contexts of one closure and the threads that work on them.
//
// A context with messages is scheduled: it is on the stack of one worker, and whoever takes it works on it until its
// mailbox is empty. The only locks are those of a mailbox, of one stack, and of one part of the table of contexts. Each
// is held for a few instructions. The run ends when no context is scheduled.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_SATURATION_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_SATURATION_HPP

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "reasoning/dl/consequence/context.hpp"
#include "reasoning/dl/consequence/rules.hpp"

namespace geminga::consequence {

struct SaturationLimits {
  std::size_t clauses = 0;         ///< of all contexts together
  std::uint32_t alternatives = 0;  ///< of one context, see Options
  base::Budget* budget = nullptr;  ///< what all of it is taken from, if there is one
};

class Saturation {
 public:
  /// The contexts of `wanted` (predicates) answer queries.
  Saturation(const Rules& rules, std::span<const std::uint32_t> wanted, const SaturationLimits& limits);

  /// The context with this key, which is made if there is none.
  [[nodiscard]] Context& context_for(ContextKey&& key, unsigned worker);
  [[nodiscard]] const Context* find(const ContextKey& key) const;
  /// Calls `use` with each context, in any order. Not during run().
  template <typename Use>
  void for_each_context(Use&& use) const {
    for (const Part& part : parts_) {
      for (const auto& context : part.contexts) use(std::as_const(*context));
    }
  }
  void post(Context& to, MessageKind kind, const Context* from, Term f, std::span<const Literal> body,
            std::span<const Literal> head, unsigned worker);
  /// The arena for what is made before and after run().
  [[nodiscard]] base::Arena& arena() { return stacks_[0].arena; }
  /// Works until nothing is left to do or the limit is reached. An exception of one thread ends the work of all and is
  /// thrown here; then nothing may be asked.
  void run(unsigned threads);

  /// Counts clauses. False if there were too many: all threads stop.
  bool count(std::size_t clauses);
  /// Counts attempts to match a body, most of which give nothing new. False if there were too many: all threads stop.
  bool count_attempts(std::size_t attempts);
  /// Counts messages that were taken out of a mailbox.
  void note_received(std::size_t messages) { waiting_.fetch_sub(messages, std::memory_order_relaxed); }
  /// Whether too many messages waited at once: all threads stop.
  [[nodiscard]] bool is_flooded() const { return is_flooded_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::size_t max_messages() const { return always_waiting + limits_.clauses; }
  /// An individual cannot exist, so everything follows.
  void contradict() {
    is_contradictory_.store(true, std::memory_order_relaxed);
    give_up();
  }
  [[nodiscard]] bool is_contradictory() const { return is_contradictory_.load(std::memory_order_relaxed); }
  /// The most alternatives of one context. It is smaller once many contexts had more, because others probably have,
  /// too.
  [[nodiscard]] std::uint32_t max_alternatives() const {
    return cut_contexts_.load(std::memory_order_relaxed) < many_cut_contexts
               ? limits_.alternatives
               : std::min(limits_.alternatives, few_alternatives);
  }
  void note_cut_context() { cut_contexts_.fetch_add(1, std::memory_order_relaxed); }
  [[nodiscard]] bool has_cut_context() const { return cut_contexts_.load(std::memory_order_relaxed) > 0; }
  void give_up() { is_cut_off_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool is_cut_off() const { return is_cut_off_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::size_t clause_count() const { return clauses_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::size_t context_count() const { return context_count_.load(std::memory_order_relaxed); }
  [[nodiscard]] const Rules& rules() const { return rules_; }

 private:
  static constexpr std::size_t parts = 64;
  /// This many attempts count as one clause, so that work that derives little ends, too.
  static constexpr std::size_t attempts_per_clause = 100;
  static constexpr std::size_t many_cut_contexts = 256;
  static constexpr std::uint32_t few_alternatives = 16;
  /// The messages that may wait at once, in addition to as many as there may be clauses. Each has some forty octets.
  static constexpr std::size_t always_waiting = 1'000'000;
  /// Filing a clause takes about as long as this many attempts.
  static constexpr std::size_t steps_per_clause = 8;
  struct Part {
    mutable SpinLock lock;
    std::vector<std::unique_ptr<Context>> contexts;
    std::vector<std::uint32_t> slots;  ///< positions from 1, by hash of the key; 0: free
  };
  struct Stack {
    SpinLock lock;
    std::vector<Context*> contexts;
    base::Arena arena;
  };

  void schedule(Context& context, unsigned worker);
  [[nodiscard]] Context* take(unsigned worker);
  void work(unsigned worker);
  void wake_all();

  const Rules& rules_;
  std::vector<bool> is_wanted_;
  SaturationLimits limits_;
  std::deque<Stack> stacks_;
  std::array<Part, parts> parts_;  ///< after the stacks, whose arenas the contexts are in
  std::atomic<std::size_t> scheduled_{0};
  std::atomic<std::uint32_t> epoch_{0};
  std::atomic<std::uint32_t> sleepers_{0};
  std::atomic<std::size_t> clauses_{0};
  std::atomic<std::size_t> attempts_{0};
  std::atomic<std::size_t> context_count_{0};
  std::atomic<std::size_t> waiting_{0};  ///< messages
  std::atomic<bool> is_flooded_{false};
  std::atomic<bool> is_cut_off_{false};
  std::atomic<bool> is_contradictory_{false};
  std::atomic<std::size_t> cut_contexts_{0};
  std::atomic<bool> is_abandoned_{false};  ///< a thread has thrown
};

}  // namespace geminga::consequence

#endif
