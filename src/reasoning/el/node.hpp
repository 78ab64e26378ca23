// What is known of one class, or of all that has one link, while a closure is inherited; and what nodes tell each
// other.
#ifndef GEMINGA_REASONING_EL_NODE_HPP
#define GEMINGA_REASONING_EL_NODE_HPP

#include <atomic>
#include <cstdint>
#include <limits>

#include "base/arena_containers.hpp"
#include "base/parallel/mailbox.hpp"
#include "base/stable_store.hpp"
#include "reasoning/el/indexed_ontology.hpp"

namespace geminga::el {

inline constexpr std::uint32_t no_node = std::numeric_limits<std::uint32_t>::max();

/// What one node tells another.
struct NodeMessage {
  enum class Kind : std::uint8_t {
    child,      ///< the node `first` is below it and wants to have all that it has
    source,     ///< the node `first` is of what has a link to it
    inherited,  ///< items of a node above it; `first` is made of Delivery
    found,      ///< existentials that what it leads to shows to be above it; `first` is as for inherited
    composed,   ///< it is below the existential of the role `first` and the node `second`
    bottom,     ///< it is unsatisfiable
    release,    ///< it need not wait any longer for those above it: they wait for it
  };
  Kind kind = Kind::bottom;
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

/// Bits of NodeMessage::first.
enum Delivery : std::uint32_t {
  further_delivery = 0,
  first_delivery = 1,
  final_delivery = 2,  ///< who tells it is final
};

/// A message that waits for the thread that will work on the node. The items of inherited and found follow it.
struct QueuedNodeMessage {
  QueuedNodeMessage* next = nullptr;
  NodeMessage message;
  std::uint32_t item_count = 0;
};

/// A node is of an atom A, or of an existential R some A. Its items are its subsumers as far as somebody below may want
/// them: expressions with rules, marks of disjointness axioms, and links (inheritance.hpp).
///
/// It is final when all that is above it is: then nothing can come any more, and what nobody is expected to ask for is
/// let go. Who asks for it all the same lets it begin anew, once.
struct alignas(32) Node {
  base::ArenaSet<std::uint32_t> items;
  std::uint32_t root = 0;          ///< the atom; of an existential, its role
  std::uint32_t filler = no_node;  ///< of an existential: the node that it leads to
  std::uint32_t pending = 0;       ///< how many nodes that it asked have not told it anything yet
  std::uint32_t expected = 0;      ///< how many will ask, by what is told
  parallel::Mailbox<QueuedNodeMessage> mailbox;
  /// Nobody else may touch the node but the worker of this rank, for whom it cannot change; 0: it is at rest.
  std::atomic<std::uint8_t> owner = 0;
  bool is_unsatisfiable : 1 = false;
  bool is_nonempty : 1 = false;
  bool is_queued : 1 = false;
  bool has_begun : 1 = false;    ///< it has asked for what is above it
  bool is_released : 1 = false;  ///< others have heard of its items
  bool is_stalled : 1 = false;   ///< a worker will release it when there is nothing else to do
  bool is_open : 1 = false;      ///< something above it was not final when it told it
  bool is_final : 1 = false;
  bool is_dropped : 1 = false;   ///< its items were let go
  bool is_kept : 1 = false;      ///< they were once, and will not be again
  std::uint32_t items_told = 0;  ///< what children_served and sources_told know of
  std::uint32_t children_served = 0;
  std::uint32_t sources_told = 0;
  std::uint32_t selfs_told = 0;
  base::ArenaList<std::uint32_t> todo;      ///< items that were concluded here, whose rules are still to be applied
  base::ArenaList<std::uint32_t> children;  ///< nodes right below
  base::ArenaList<std::uint32_t> sources;   ///< nodes of existentials whose filler this is
  base::ArenaList<std::uint32_t> above;     ///< right above, where no told axiom puts it: atoms, and nodes behind them
  base::ArenaList<RoleId> selfs;

  [[nodiscard]] bool is_existential() const { return filler != no_node; }
};

using NodeStore = base::StableStore<Node>;

}  // namespace geminga::el

#endif
