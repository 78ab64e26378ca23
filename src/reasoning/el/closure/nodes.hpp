// The nodes of a closure by inheritance: made once for each atom and each existential, in the order of the seeds.
#ifndef GEMINGA_REASONING_EL_CLOSURE_NODES_HPP
#define GEMINGA_REASONING_EL_CLOSURE_NODES_HPP

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <vector>

#include "base/interner.hpp"
#include "reasoning/el/closure/context_queue.hpp"
#include "reasoning/el/closure/limits.hpp"
#include "reasoning/el/closure/node.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

/// The nodes of one closure, which all its workers share.
struct SharedNodes {
  SharedNodes(const IndexedOntology& of, const SaturationLimits& within, std::span<const ExprId> asked);

  const IndexedOntology& index;
  SaturationLimits limits;
  std::uint32_t first_link;  ///< items from here on are nodes of existentials
  NodeStore contexts;
  std::vector<std::atomic<std::uint32_t>> node_of;  ///< by atom: no_node_yet, claimed_node, or the number and 2
  std::vector<std::uint32_t> expected;              ///< by atom: how many nodes will ask for its items, by what is told
  /// The nodes of existentials by role and filler, in parts with a lock each.
  struct Part {
    std::mutex mutex;
    base::NumberTable table;
  };
  static constexpr std::size_t part_count = 64;
  std::array<Part, part_count> existentials;
  std::span<const ExprId> seeds;  ///< atoms whose closures are asked for
  std::atomic<std::size_t> next_seed = 0;
  std::atomic<std::size_t> seeds_let_in = 0;  ///< seeds of this round and of earlier rounds
  std::size_t closed = 0;                     ///< nodes that were closed at the end of a round
  std::atomic<bool> is_inconsistent = false;
  std::atomic<bool> is_over_limit = false;
  std::atomic<bool> is_cut_off = false;  ///< over the budget

  static constexpr std::uint32_t no_node_yet = 0;
  static constexpr std::uint32_t claimed_node = 1;
  static constexpr std::uint32_t any_number = std::numeric_limits<std::uint32_t>::max();

  /// The node of an atom, or no_node if it was never required.
  [[nodiscard]] std::uint32_t find(ExprId atom) const {
    const std::uint32_t entry = node_of[number(atom)].load(std::memory_order_relaxed);
    return entry <= claimed_node ? no_node : entry - 2;
  }
  [[nodiscard]] bool has_ended() const {
    return is_inconsistent.load(std::memory_order_relaxed) || is_over_limit.load(std::memory_order_relaxed);
  }
};

/// One worker's queue of nodes. It makes nodes and queues them.
class Nodes {
 public:
  Nodes(SharedNodes& shared, std::uint8_t rank)
      : shared_(shared), nodes_(shared.contexts), queue_(shared.contexts, rank) {}

  /// The node of an atom; makes it if there is none.
  std::uint32_t require(ExprId atom);
  /// The node of `role some filler`; makes it if there is none.
  std::uint32_t require_existential(RoleId role, std::uint32_t filler);
  /// A new node of no atom.
  std::uint32_t add_nameless();
  /// Queues nodes of seeds of this round, if the queue is empty. False if none is left.
  bool begin_more();
  /// Lets more seeds into the next round and begins. False if none is left.
  bool begin_next_seeds();

  [[nodiscard]] ContextQueue<NodeStore, QueuedNodeMessage>& queue() { return queue_; }
  /// The number of existentials for which this worker made nodes.
  [[nodiscard]] std::size_t link_count() const { return links_; }

 private:
  SharedNodes& shared_;
  NodeStore& nodes_;
  ContextQueue<NodeStore, QueuedNodeMessage> queue_;
  std::size_t links_ = 0;
};

}  // namespace geminga::el

#endif
