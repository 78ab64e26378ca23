// The nodes that may block others, found by a hash of their labels.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_GRAPH_BLOCKERS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_GRAPH_BLOCKERS_HPP

#include <cstdint>
#include <vector>

#include "reasoning/dl/hypertableau/graph/graph.hpp"

namespace geminga::hypertableau {

/// A stack of nodes in ascending order. From the first changed node on it is cut and filled again, so that the older
/// nodes, which are most, are not looked at again.
class Blockers {
 public:
  /// Adds a node that is greater than all others.
  void push(NodeId node, std::uint64_t key);
  /// Removes this node and all greater ones.
  void cut(NodeId first);

  /// The newest node with this key of which `is_wanted` holds; none where there is none.
  template <typename IsWanted>
  [[nodiscard]] NodeId find(std::uint64_t key, IsWanted&& is_wanted) const {
    if (heads_.empty()) return none;
    for (std::uint32_t at = heads_[slot_of(key)]; at != none; at = entries_[at].older) {
      if (entries_[at].key == key && is_wanted(entries_[at].node)) return entries_[at].node;
    }
    return none;
  }

 private:
  struct Entry {
    std::uint64_t key = 0;
    NodeId node = 0;
    std::uint32_t older = none;  ///< the next entry in the same slot
  };
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const { return (key ^ (key >> 29)) & (heads_.size() - 1); }
  void grow();

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> heads_;  ///< the newest entry of each slot
};

}  // namespace geminga::hypertableau

#endif
