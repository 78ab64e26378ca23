// One thread's part of a saturation: applies the rules to one context after the other.
//
// A context is worked on by one thread at a time, which alone touches what is in it. What a rule concludes about
// another context goes there at once where one thread does everything. Among many, the thread that finds the other
// context at rest takes it for its own and puts it on its queue; of one that another thread has it posts a message to
// the mailbox. So there is no lock around the closure (threads.hpp says how queues are shared).
#ifndef GEMINGA_REASONING_EL_SATURATION_WORKER_HPP
#define GEMINGA_REASONING_EL_SATURATION_WORKER_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/arena.hpp"
#include "reasoning/el/context.hpp"
#include "reasoning/el/rules.hpp"
#include "reasoning/el/saturation.hpp"
#include "reasoning/el/work_count.hpp"

namespace geminga::el {

class SaturationWorker : private Rules<SaturationWorker> {
 public:
  /// Ranks are from 1.
  SaturationWorker(Saturating& shared, std::uint8_t rank)
      : Rules(shared.index), shared_(shared), contexts_(shared.contexts), work_(shared), rank_(rank) {}

  std::uint32_t require(ExprId root);
  void require_nonempty(std::uint32_t context);
  void conclude(std::uint32_t context, ExprId expr) { add_subsumer(context, expr); }

  /// Works through its queue, alone.
  void run_alone();
  /// Reads the messages of a context of its queue and works on it until no more come. For one of many.
  void work_on(std::uint32_t context);
  /// What is on its queue is in its hand from then on. Before there are threads, and after.
  void set_parallel(bool is_parallel);
  /// All that is to be done is on queues from the start.
  bool begin_more() { return false; }
  bool release_one() { return false; }
  bool begin_round() { return false; }
  [[nodiscard]] std::uint8_t rank() const { return rank_; }
  /// The contexts to be worked on, the next one last.
  [[nodiscard]] std::vector<std::uint32_t>& queue() { return queue_; }
  [[nodiscard]] std::size_t conclusion_count() const { return conclusions_; }
  [[nodiscard]] std::size_t link_count() const { return links_; }

 private:
  friend class Rules<SaturationWorker>;
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  // How conclusions travel.
  [[nodiscard]] bool is_elsewhere(std::uint32_t context) const {
    return is_parallel_ && contexts_[context].owner.load(std::memory_order_relaxed) != rank_;
  }
  void post(std::uint32_t context, const Message& message);
  void receive(std::uint32_t context, const Message& message);
  void enqueue(std::uint32_t context);
  void process(std::uint32_t context);

  // What the rules ask of a closure (rules.hpp); each conclusion is noted where it is new.
  static constexpr bool inherits = false;
  void add_subsumer(std::uint32_t context, ExprId subsumer);
  void add_atom(std::uint32_t context, ExprId atom);
  void add_bottom(std::uint32_t context);
  void add_link(std::uint32_t from, RoleId role, std::uint32_t to, bool is_last = false);
  void add_composed_link(std::uint32_t from, RoleId first, RoleId second, RoleId result, std::uint32_t to) {
    add_link(from, result, to, index_.roles().is_last(first, second, result));
  }
  void add_self(std::uint32_t context, RoleId role);
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
  void count_work(std::size_t premises) { work_.add(premises); }

  // Rules by the premise that is new.
  void process_subsumer(std::uint32_t context, ExprId subsumer);
  void process_backward(std::uint32_t context, Link link);
  void process_first(std::uint32_t context, Link link);
  void process_forward(std::uint32_t context, Link link);
  void add_forward(std::uint32_t from, Link link);
  void start(std::uint32_t context, std::span<const ExprId> atoms);

  // Contexts of several atoms (saturation_together.cpp).
  std::uint32_t require_together(const std::vector<ExprId>& atoms);
  [[nodiscard]] std::vector<ExprId> members_of(std::uint32_t context) const;

  // Universals (saturation_universals.cpp).
  std::uint32_t successor_of(std::uint32_t context, const LinkRule& link);
  void process_universal(std::uint32_t context, ExprId subsumer);
  void process_universal_self(std::uint32_t context, RoleId role);

  // Nominals (saturation_nominals.cpp); one thread only, for they reach into other contexts.
  void process_nominal(std::uint32_t context, ExprId nominal);
  [[nodiscard]] bool is_of_values(std::uint32_t context) const;
  void merge_into_nominal(std::uint32_t context, std::uint32_t nominal);
  void find_selfs(std::uint32_t context, std::uint32_t nominal);
  void find_self_of_link(std::uint32_t from, RoleId role, std::uint32_t to);

  Saturating& shared_;
  ContextStore& contexts_;
  WorkCount<Saturating> work_;
  std::uint8_t rank_;
  bool is_parallel_ = false;
  std::size_t conclusions_ = 0;
  std::size_t links_ = 0;
  std::vector<std::uint32_t> queue_;
  /// What was posted of late: a table in which the new displaces the old.
  struct Posted {
    std::uint32_t context = nowhere;
    Message message;
  };
  static constexpr std::size_t posted_count = std::size_t{1} << 15;
  std::vector<Posted> posted_;
  base::Arena arena_;
};

}  // namespace geminga::el

#endif
