// One thread's part of a closure by inheritance: works on one node after the other.
//
// A node is worked on by one thread at a time, which alone touches what is in it. What others have to tell it goes
// there at once where one thread does everything, or where this thread has the node in hand; else through its mailbox
// (saturation_worker.hpp).
//
// Order decides how much is copied twice. A node tells its children nothing before it has heard of everything above it,
// so that what is without cycles is closed from the top, each node once. Where nodes wait for each other in a circle,
// one of them is released when there is nothing else to do.
#ifndef GEMINGA_REASONING_EL_INHERITANCE_WORKER_HPP
#define GEMINGA_REASONING_EL_INHERITANCE_WORKER_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.hpp"
#include "reasoning/el/inheritance.hpp"
#include "reasoning/el/node.hpp"
#include "reasoning/el/rules.hpp"
#include "reasoning/el/work_count.hpp"

namespace geminga::el {

class InheritanceWorker : private Rules<InheritanceWorker> {
 public:
  /// Ranks are from 1.
  InheritanceWorker(Inheriting& shared, std::uint8_t rank)
      : Rules(shared.index), shared_(shared), nodes_(shared.contexts), work_(shared), rank_(rank) {}

  /// The node of an atom, or of what is above it where it has nothing itself.
  std::uint32_t require(ExprId atom);

  void run_alone();
  /// Reads the messages of a node of its queue and works on it until no more come. For one of many.
  void work_on(std::uint32_t node);
  /// Puts something on the empty queue: what was asked for and not yet begun.
  bool begin_more();
  /// Puts something on the empty queue: a node that waits in a circle.
  bool release_one();
  /// Where nothing is to be done anywhere: closes what has begun, and lets more begin. False where that was all.
  bool begin_round();
  /// What is on its queue is in its hand from then on. Before there are threads, and after.
  void set_parallel(bool is_parallel);
  [[nodiscard]] std::uint8_t rank() const { return rank_; }
  [[nodiscard]] std::vector<std::uint32_t>& queue() { return queue_; }
  [[nodiscard]] std::size_t conclusion_count() const { return conclusions_; }
  [[nodiscard]] std::size_t link_count() const { return links_; }

 private:
  friend class Rules<InheritanceWorker>;
  using Items = std::span<const std::uint32_t>;

  // How nodes hear of each other.
  [[nodiscard]] bool is_elsewhere(std::uint32_t node) const {
    return is_parallel_ && nodes_[node].owner.load(std::memory_order_relaxed) != rank_;
  }
  void tell(std::uint32_t node, const NodeMessage& message, Items items = {});
  void post(std::uint32_t node, const NodeMessage& message, Items items);
  void receive(std::uint32_t node, const NodeMessage& message, Items items);
  void enqueue(std::uint32_t node);
  void take_in_hand(std::uint32_t node);
  void process(std::uint32_t node);
  void stall(std::uint32_t node);
  void let_go(std::uint32_t node);
  void begin_anew(std::uint32_t node);

  // Nodes above.
  std::uint32_t require_existential(RoleId role, std::uint32_t filler);
  void start(std::uint32_t node);
  void inherit(std::uint32_t node, std::uint32_t from);

  // What the rules ask of a closure (rules.hpp); each conclusion is noted where it is new.
  static constexpr bool inherits = true;
  void add_subsumer(std::uint32_t node, ExprId item);
  void add_atom(std::uint32_t node, ExprId atom);
  void add_bottom(std::uint32_t node);
  void add_link(std::uint32_t node, RoleId role, std::uint32_t filler);
  void add_self(std::uint32_t node, RoleId role);
  void add_loop(std::uint32_t node, RoleId role);
  void add_filler(std::uint32_t node, ExprId item);
  [[nodiscard]] bool add_mark(std::uint32_t node, std::uint32_t mark) {
    return nodes_[node].items.insert(mark, arena_);
  }
  [[nodiscard]] std::uint32_t successor_of(std::uint32_t /*node*/, const LinkRule& link) { return require(link.root); }
  [[nodiscard]] bool is_unsatisfiable(std::uint32_t node) const { return nodes_[node].is_unsatisfiable; }
  [[nodiscard]] const auto& subsumers(std::uint32_t node) const { return nodes_[node].items; }
  [[nodiscard]] const auto& selfs(std::uint32_t node) const { return nodes_[node].selfs; }
  [[nodiscard]] std::uint32_t selfs_done(std::uint32_t node) const { return nodes_[node].selfs.size(); }
  void count_work(std::size_t premises) { work_.add(premises); }

  // What is inherited.
  void add_inherited(std::uint32_t node, Items items);
  void process_inherited(std::uint32_t node, std::uint32_t item);
  void compose_with_link(std::uint32_t node, RoleId first, std::uint32_t item);

  // What a node hands on.
  void tell_sources(std::uint32_t node);
  void tell_source(std::uint32_t node, std::uint32_t source, bool is_new, Items items);
  void serve_children(std::uint32_t node);
  void tell_bottom(std::uint32_t node);
  [[nodiscard]] std::uint32_t delivery_of(std::uint32_t node, bool is_new) const;
  [[nodiscard]] bool has_conjunctions(std::uint32_t item) const;
  [[nodiscard]] bool is_filler(std::uint32_t item) const;

  Inheriting& shared_;
  NodeStore& nodes_;
  WorkCount<Inheriting> work_;
  std::uint8_t rank_;
  bool is_parallel_ = false;
  std::size_t conclusions_ = 0;
  std::size_t links_ = 0;
  std::vector<std::uint32_t> queue_;    ///< the next one last
  std::vector<std::uint32_t> stalled_;  ///< nodes that had to wait when they were last worked on
  std::vector<std::uint32_t> all_items_;
  std::vector<std::uint32_t> new_items_;
  std::vector<std::uint32_t> found_;
  base::Arena arena_;
};

}  // namespace geminga::el

#endif
