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
#include "reasoning/el/saturation.hpp"
#include "reasoning/el/work_count.hpp"

namespace geminga::el {

class SaturationWorker {
 public:
  /// Ranks are from 1.
  SaturationWorker(Saturating& shared, std::uint8_t rank)
      : shared_(shared), index_(shared.index), contexts_(shared.contexts), work_(shared), rank_(rank) {}

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
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  // How conclusions travel.
  [[nodiscard]] bool is_elsewhere(std::uint32_t context) const {
    return is_parallel_ && contexts_[context].owner.load(std::memory_order_relaxed) != rank_;
  }
  void post(std::uint32_t context, const Message& message);
  void receive(std::uint32_t context, const Message& message);
  void enqueue(std::uint32_t context);
  void process(std::uint32_t context);

  // Conclusions: each is noted where it is new.
  void add_subsumer(std::uint32_t context, ExprId subsumer);
  void add_link(std::uint32_t from, RoleId role, std::uint32_t to, bool is_last = false);
  void add_forward(std::uint32_t from, Link link);
  void add_bottom(std::uint32_t context);
  void add_derived_atom(std::uint32_t context, ExprId atom);
  void add_self(std::uint32_t context, RoleId role);
  void add_disjointness(std::uint32_t context, std::uint32_t axiom);

  // Rules, by the premise that is new.
  void process_subsumer(std::uint32_t context, ExprId subsumer);
  void propagate(Link link, ExprId filler);
  void process_backward(std::uint32_t context, Link link);
  void process_first(std::uint32_t context, Link link);
  void process_forward(std::uint32_t context, Link link);
  void process_self(std::uint32_t context, RoleId role);
  void apply_conjunctions(std::uint32_t context, std::span<const ConjunctionRule> rules);
  void compose(std::uint32_t from, RoleId first, RoleId second, std::uint32_t to);
  void start(std::uint32_t context, std::span<const ExprId> atoms);

  // Functional properties (saturation_functional.cpp).
  std::uint32_t require_together(const std::vector<ExprId>& atoms);
  [[nodiscard]] std::vector<ExprId> atoms_of(std::uint32_t context) const;
  void group_successor(std::uint32_t context, RoleId functional, Link link);
  void process_functional(std::uint32_t context, Link link);
  void process_functional_self(std::uint32_t context, RoleId functional);

  // Universals (saturation_universals.cpp).
  std::uint32_t require_restricted(std::uint32_t context, const LinkRule& link);
  void process_universal(std::uint32_t context, ExprId subsumer);
  void process_universal_self(std::uint32_t context, RoleId role);

  // Nominals (saturation_nominals.cpp); one thread only, for they reach into other contexts.
  void process_nominal(std::uint32_t context, ExprId nominal);
  [[nodiscard]] bool is_of_values(std::uint32_t context) const;
  void merge_into_nominal(std::uint32_t context, std::uint32_t nominal);
  void find_selfs(std::uint32_t context, std::uint32_t nominal);
  void find_self_of_link(std::uint32_t from, RoleId role, std::uint32_t to);

  Saturating& shared_;
  const IndexedOntology& index_;
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
