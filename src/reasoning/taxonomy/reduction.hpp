// From inclusions between nodes to a reduced hierarchy of entities: nodes of equivalents, and the direct parents of
// each.
#ifndef GEMINGA_REASONING_TAXONOMY_REDUCTION_HPP
#define GEMINGA_REASONING_TAXONOMY_REDUCTION_HPP

#include <cstdint>
#include <utility>
#include <vector>

namespace geminga::taxonomy {

/// A graph whose ways up are all inclusions that hold. Some of its nodes are entities (classes, properties), others
/// stand between them; more entities may share a node.
struct Inclusions {
  std::uint32_t node_count = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< sub, super
  std::vector<bool> is_empty;                                  ///< by node: it is below the bottom entity
  std::uint32_t top = 0;                                       ///< the node above all others, with edges or without
  std::vector<std::uint32_t> node_of;                          ///< by entity
  std::uint32_t top_entity = 0;
  std::uint32_t bottom_entity = 0;
  bool is_consistent = true;  ///< false: every node is empty
};

/// As Classification says it of classes.
struct Reduced {
  std::vector<std::uint32_t> representative;
  std::vector<std::uint32_t> parent_begin;
  std::vector<std::uint32_t> parents;
  bool is_consistent = true;
};

/// Equal inclusions, in whatever order and with whatever repetitions, give equal results. Linear in nodes and edges but
/// for the sorting of parents and the size of the interval index that tells direct ones.
[[nodiscard]] Reduced reduce(Inclusions&& inclusions);

}  // namespace geminga::taxonomy

#endif
