// One thread's part of a closure by inheritance: works on one node after the other.
//
// A node sends its children nothing before it has heard from all nodes above it, so that a hierarchy without circles is
// closed from the top, each node once. Where nodes wait for each other in a circle, one of them is released when there
// is nothing else to do.
#ifndef GEMINGA_REASONING_EL_CLOSURE_INHERITANCE_WORKER_HPP
#define GEMINGA_REASONING_EL_CLOSURE_INHERITANCE_WORKER_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.hpp"
#include "reasoning/el/closure/node.hpp"
#include "reasoning/el/closure/node_deliveries.hpp"
#include "reasoning/el/closure/nodes.hpp"
#include "reasoning/el/closure/rules.hpp"
#include "reasoning/el/closure/work_count.hpp"

namespace geminga::el {

class InheritanceWorker : private Rules<InheritanceWorker> {
 public:
  /// Ranks are from 1.
  InheritanceWorker(SharedNodes& shared, std::uint8_t rank)
      : Rules(shared.index),
        shared_(shared),
        nodes_(shared.contexts),
        made_(shared, rank),
        queue_(made_.queue()),
        deliveries_(shared, *this),
        work_(shared) {}

  std::uint32_t require(ExprId atom) { return made_.require(atom); }

  // For ranges.hpp: more nodes for a closure that rests, closed by run_alone().
  /// A new node right below this one. It is never taken over by others.
  std::uint32_t add_below(std::uint32_t node);
  /// Puts a node right below an atom, too.
  void put_below(std::uint32_t node, ExprId atom) { add_atom(node, atom); }
  /// Lets the node of an existential hear of this node, too, as of its filler.
  void lead_to(std::uint32_t existential, std::uint32_t node);

  /// Closes everything, as the only worker.
  void run_alone();

  // As one worker of a parallel::Team.
  void work_on(std::uint32_t node);
  void set_parallel(bool is_parallel) { queue_.set_parallel(is_parallel); }
  [[nodiscard]] std::uint8_t rank() const { return queue_.rank(); }
  [[nodiscard]] std::vector<std::uint32_t>& queue() { return queue_.numbers(); }
  [[nodiscard]] std::size_t conclusion_count() const { return conclusions_; }
  [[nodiscard]] std::size_t link_count() const { return made_.link_count(); }
  bool begin_more() { return made_.begin_more(); }
  /// Queues a node that waits in a circle, if the queue is empty.
  bool release_one();
  /// Closes the nodes that have begun, when no worker has anything to do, and begins more. False if none is left.
  bool begin_round();

 private:
  friend class Rules<InheritanceWorker>;
  friend class NodeDeliveries<InheritanceWorker>;
  using Items = std::span<const std::uint32_t>;

  // Messages.
  void tell(std::uint32_t node, const NodeMessage& message, Items items = {});
  void receive(std::uint32_t node, const NodeMessage& message, Items items);
  void tell_bottom(std::uint32_t node);

  // The life of a node.
  void process(std::uint32_t node);
  void start(std::uint32_t node);
  void inherit(std::uint32_t node, std::uint32_t from);
  void inherit_above(std::uint32_t node, std::uint32_t above);
  void stall(std::uint32_t node);
  void let_go(std::uint32_t node);
  void begin_anew(std::uint32_t node);

  // A closure for Rules; each conclusion is noted where it is new.
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

  // Inherited items.
  void add_inherited(std::uint32_t node, Items items);
  void process_inherited(std::uint32_t node, std::uint32_t item);
  void compose_with_link(std::uint32_t node, RoleId first, std::uint32_t item);

  SharedNodes& shared_;
  NodeStore& nodes_;
  Nodes made_;
  ContextQueue<NodeStore, QueuedNodeMessage>& queue_;
  NodeDeliveries<InheritanceWorker> deliveries_;
  WorkCount<SharedNodes> work_;
  std::size_t conclusions_ = 0;
  std::vector<std::uint32_t> stalled_;  ///< nodes that had to wait when they were last worked on
  base::Arena arena_;
};

}  // namespace geminga::el

#endif
