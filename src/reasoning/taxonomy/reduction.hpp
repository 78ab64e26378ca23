// The reduction of inclusions to a hierarchy: nodes of equivalent entities, and the direct parents of each.
#ifndef GEMINGA_REASONING_TAXONOMY_REDUCTION_HPP
#define GEMINGA_REASONING_TAXONOMY_REDUCTION_HPP

#include <cstdint>
#include <utility>
#include <vector>

namespace geminga::taxonomy {

/// A graph in which a path upwards is an inclusion. Some nodes are entities (classes, properties), others stand between
/// them. Several entities may share a node.
struct Inclusions {
  std::uint32_t node_count = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< sub, super
  std::vector<bool> is_empty;                                  ///< by node: it is below the bottom entity
  std::uint32_t top = 0;                                       ///< the node above all others, even without edges
  std::vector<std::uint32_t> node_of;                          ///< by entity
  std::uint32_t top_entity = 0;
  std::uint32_t bottom_entity = 0;
  bool is_consistent = true;  ///< false: every node is empty
};

/// The hierarchy in the form that Classification has of classes.
struct Reduced {
  std::vector<std::uint32_t> representative;
  std::vector<std::uint32_t> parent_begin;
  std::vector<std::uint32_t> parents;
  bool is_consistent = true;
};

/// Reduces a graph. The result depends only on the set of inclusions. Linear in nodes and edges, except for sorting
/// parents and for the interval index that finds the direct ones.
[[nodiscard]] Reduced reduce(Inclusions&& inclusions);

}  // namespace geminga::taxonomy

#endif
