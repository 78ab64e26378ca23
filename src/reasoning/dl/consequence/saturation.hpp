// One saturation: the contexts, and the threads that work on them.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_SATURATION_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_SATURATION_HPP

#include <cstdint>
#include <span>

#include "reasoning/dl/consequence/context_table.hpp"
#include "reasoning/dl/consequence/effort.hpp"
#include "reasoning/dl/consequence/outbox.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"
#include "reasoning/dl/consequence/schedule.hpp"

namespace geminga::consequence {

class Saturation {
 public:
  /// The contexts of `wanted` (predicates) answer queries.
  Saturation(const Rules& rules, std::span<const std::uint32_t> wanted, const SaturationLimits& limits)
      : rules_(rules), effort_(limits), contexts_(rules, wanted) {}

  /// Makes the context of a concept that is asked for. Before run().
  void ask(ContextKey&& key);
  /// Says that something certainly is in this context. Before run().
  void assert_existence(ContextKey&& key);
  /// Works until nothing is left to do or a limit is reached. An exception of one thread ends the work of all and is
  /// thrown here; then nothing may be asked.
  void run(unsigned threads);

  [[nodiscard]] const ContextTable& contexts() const { return contexts_; }
  [[nodiscard]] const SharedEffort& effort() const { return effort_; }
  /// The memory of keys and contexts outside of run(); see ArenaUse.
  [[nodiscard]] base::Arena& arena() { return schedule_.arena(0); }

 private:
  [[nodiscard]] Outbox outbox(unsigned thread) { return {contexts_, schedule_, effort_, thread}; }

  const Rules& rules_;
  SharedEffort effort_;
  Schedule schedule_;
  ContextTable contexts_;  ///< after the schedule, whose arenas the contexts are in
};

}  // namespace geminga::consequence

#endif
