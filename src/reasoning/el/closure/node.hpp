// A node of a closure by inheritance: the items of one class or of one existential, and the messages between nodes.
#ifndef GEMINGA_REASONING_EL_CLOSURE_NODE_HPP
#define GEMINGA_REASONING_EL_CLOSURE_NODE_HPP

#include <atomic>
#include <cstdint>
#include <limits>

#include "base/arena_containers.hpp"
#include "base/parallel/mailbox.hpp"
#include "base/stable_store.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

inline constexpr std::uint32_t no_node = std::numeric_limits<std::uint32_t>::max();

/// A message to a node.
struct NodeMessage {
  enum class Kind : std::uint8_t {
    child,      ///< the node `first` is below this one and wants its items
    source,     ///< the node `first` is an existential whose filler this node is
    inherited,  ///< items of a node above; `first` is made of Delivery
    found,      ///< existentials above, found by the filler; `first` is as for inherited
    composed,   ///< this node is below the existential of the role `first` and the node `second`
    bottom,     ///< this node is unsatisfiable
    release,    ///< this node need not wait for the nodes above it: they wait for it
  };
  Kind kind = Kind::bottom;
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

/// Bits of NodeMessage::first.
enum Delivery : std::uint32_t {
  further_delivery = 0,
  first_delivery = 1,
  final_delivery = 2,  ///< the sender is final
};

/// A message in a mailbox. The items of inherited and found follow it in memory.
struct QueuedNodeMessage {
  QueuedNodeMessage* next = nullptr;
  NodeMessage message;
  std::uint32_t item_count = 0;
};

/// The node of an atom A or of an existential R some A. Its items are the subsumers that a node below may need:
/// expressions with rules, marks of disjointness axioms, and links (inheritance.hpp).
///
/// A node is final when all nodes above it are: then no item can come. Items that no node is expected to ask for are
/// freed; a node that asks for them all the same begins it anew, once.
struct alignas(32) Node {
  base::ArenaSet<std::uint32_t> items;
  std::uint32_t root = 0;          ///< the atom, or no_node; of an existential, its role
  std::uint32_t filler = no_node;  ///< of an existential: the node that it leads to
  std::uint32_t pending = 0;       ///< how many nodes that it asked have not answered yet
  std::uint32_t expected = 0;      ///< how many nodes will ask for its items, by what is told
  parallel::Mailbox<QueuedNodeMessage> mailbox;
  /// The rank of the worker that holds the node, which alone may touch it; 0: none.
  std::atomic<std::uint8_t> owner = 0;
  bool is_unsatisfiable : 1 = false;
  bool is_nonempty : 1 = false;
  bool is_queued : 1 = false;
  bool has_begun : 1 = false;    ///< it has asked for the items of the nodes above it
  bool is_released : 1 = false;  ///< it has sent its items to others
  bool is_stalled : 1 = false;   ///< a worker will release it when there is nothing else to do
  bool is_open : 1 = false;      ///< a node above it was not final when it sent its items
  bool is_final : 1 = false;
  bool is_dropped : 1 = false;   ///< its items were freed
  bool is_kept : 1 = false;      ///< its items were freed once and will not be again
  std::uint32_t items_told = 0;  ///< how many items the nodes up to children_served and sources_told know
  std::uint32_t children_served = 0;
  std::uint32_t sources_told = 0;
  std::uint32_t selfs_told = 0;
  base::ArenaList<std::uint32_t> todo;      ///< items that were concluded here and whose rules are still to be applied
  base::ArenaList<std::uint32_t> children;  ///< nodes right below
  base::ArenaList<std::uint32_t> sources;   ///< nodes of existentials whose filler this node is
  base::ArenaList<std::uint32_t> above;     ///< right above, where no told axiom puts it: atoms, and nodes behind them
  base::ArenaList<RoleId> selfs;

  [[nodiscard]] bool is_existential() const { return filler != no_node; }
};

using NodeStore = base::StableStore<Node>;

}  // namespace geminga::el

#endif
