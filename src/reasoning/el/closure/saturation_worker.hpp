// One thread's part of a saturation: works on one context after the other and applies the rules to each new premise.
#ifndef GEMINGA_REASONING_EL_CLOSURE_SATURATION_WORKER_HPP
#define GEMINGA_REASONING_EL_CLOSURE_SATURATION_WORKER_HPP

#include <cstdint>
#include <vector>

#include "reasoning/el/closure/conclusions.hpp"
#include "reasoning/el/closure/context.hpp"
#include "reasoning/el/closure/nominal_rules.hpp"
#include "reasoning/el/closure/rules.hpp"
#include "reasoning/el/closure/universal_rules.hpp"

namespace geminga::el {

/// The rules of rules.hpp note what they conclude by the functions of Conclusions.
class SaturationWorker : private Conclusions, private Rules<SaturationWorker> {
 public:
  /// Ranks are from 1.
  SaturationWorker(SharedContexts& shared, std::uint8_t rank)
      : Conclusions(shared, rank), Rules(shared.index), nominals_(*this), universals_(*this) {}

  using Conclusions::add_subsumer;
  using Conclusions::conclusion_count;
  using Conclusions::link_count;
  using Conclusions::require;
  void require_nonempty(std::uint32_t context) { nominals_.require_nonempty(context); }

  /// Works on its queue until it is empty, as the only worker.
  void run_alone();

  // As one worker of a parallel::Team.
  void work_on(std::uint32_t context);
  void set_parallel(bool is_parallel) { queue_.set_parallel(is_parallel); }
  [[nodiscard]] std::uint8_t rank() const { return queue_.rank(); }
  [[nodiscard]] std::vector<std::uint32_t>& queue() { return queue_.numbers(); }
  /// All work is on queues from the start.
  bool begin_more() { return false; }
  bool release_one() { return false; }
  bool begin_round() { return false; }

 private:
  friend class Rules<SaturationWorker>;

  void process(std::uint32_t context);
  void process_subsumer(std::uint32_t context, ExprId subsumer);
  void process_backward(std::uint32_t context, Link link);
  void process_first(std::uint32_t context, Link link);
  void process_forward(std::uint32_t context, Link link);

  // A closure for Rules, besides the functions of Conclusions.
  static constexpr bool inherits = false;
  [[nodiscard]] std::uint32_t successor_of(std::uint32_t context, const LinkRule& link) {
    return universals_.successor_of(context, link);
  }
  void add_composed_link(std::uint32_t from, RoleId first, RoleId second, RoleId result, std::uint32_t to) {
    add_link(from, result, to, index_.roles().is_last(first, second, result));
  }
  void add_loop(std::uint32_t context, RoleId role);
  void add_filler(std::uint32_t context, ExprId subsumer);
  void add_member(std::uint32_t context, ExprId atom) { add_atom(context, atom); }
  [[nodiscard]] bool add_mark(std::uint32_t context, std::uint32_t mark) {
    return contexts_[context].subsumers.insert(mark, arena_);
  }
  [[nodiscard]] bool is_unsatisfiable(std::uint32_t context) const { return contexts_[context].is_unsatisfiable; }
  [[nodiscard]] const auto& subsumers(std::uint32_t context) const { return contexts_[context].subsumers; }
  [[nodiscard]] const auto& selfs(std::uint32_t context) const { return contexts_[context].selfs.get(); }
  [[nodiscard]] std::uint32_t selfs_done(std::uint32_t context) const { return contexts_[context].selfs_done; }
  [[nodiscard]] const auto& forward(std::uint32_t context) const { return contexts_[context].forward; }
  [[nodiscard]] std::uint32_t forward_done(std::uint32_t context) const { return contexts_[context].forward_done; }
  [[nodiscard]] std::vector<FunctionalGroup>& groups(std::uint32_t context) { return contexts_[context].groups.own(); }

  NominalRules nominals_;
  UniversalRules universals_;
};

}  // namespace geminga::el

#endif
