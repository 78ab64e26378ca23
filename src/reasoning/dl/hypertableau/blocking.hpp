// Blocking: a node need not be expanded if a node like it has been.
//
//   x is blocked by an older y that is not, if both are in the same concepts, and neither looks back at its parent
//   (program/backward_looks.hpp). If they do, their parents must be in the same concepts, too, with the same edges
//   between (pairwise anywhere blocking).
//   A node below a blocked node is blocked.
//
// The nodes of the models of earlier questions block, too: see Search::keep().
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_BLOCKING_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_BLOCKING_HPP

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/graph/blockers.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Marks the blocked nodes of the graph, and those that were merged or pruned. Remembers the blocker of each, so that
/// only changed nodes are looked at again.
class Blocking {
 public:
  Blocking(const Program& program, Graph& graph, Effort& effort) : program_(program), graph_(graph), effort_(effort) {}

  /// Updates the marks of all nodes. Returns how many nodes were looked at.
  std::size_t update();
  /// Nodes that were blocked, merged or pruned when they were looked at, and at a later look since the last call were
  /// not. Some may be blocked again.
  [[nodiscard]] std::vector<NodeId> take_unblocked() { return std::exchange(unblocked_, {}); }
  /// The node that blocks this one itself, and not an ancestor of it, as of the last look; none if there is none.
  [[nodiscard]] NodeId blocker_of(NodeId node) const;

 private:
  /// The node that blocks another one, and the versions of the nodes that were compared.
  struct BlockedBy {
    NodeId blocker = none;
    std::array<std::uint64_t, 4> versions{};
    friend bool operator==(const BlockedBy&, const BlockedBy&) = default;
  };

  void mark(NodeId node, bool is_blocked);
  [[nodiscard]] bool may_block_as_root(const Node& node) const;
  [[nodiscard]] std::uint64_t key_of(NodeId node) const;
  [[nodiscard]] bool is_still_blocked(NodeId node) const;
  /// Whether the node looks back along an edge to its parent.
  [[nodiscard]] bool looks_back(NodeId node) const;
  [[nodiscard]] bool looks_along(NodeId node, Direction direction) const;
  [[nodiscard]] BlockedBy compared(NodeId node, NodeId blocker) const;
  [[nodiscard]] bool blocks(NodeId blocker, NodeId node) const;
  [[nodiscard]] bool has_same_edges(NodeId node, NodeId other) const;

  const Program& program_;
  Graph& graph_;
  Effort& effort_;
  Blockers blockers_;
  std::vector<BlockedBy> blocked_by_;  ///< by node, as of the last look
  std::vector<bool> looks_back_;       ///< the same
  std::vector<NodeId> unblocked_;
};

}  // namespace geminga::hypertableau

#endif
