// Answers "is A under B" in a directed acyclic graph, by preorder ranks of a spanning tree and lists of intervals.
//
// Every node has a rank. The nodes below it in the tree have the ranks that follow, up to its end (Agrawal, Borgida,
// Jagadish 1989). Nodes that are below it by other edges have further intervals, which are merged if they touch.
#ifndef GEMINGA_REASONING_TAXONOMY_INTERVAL_INDEX_HPP
#define GEMINGA_REASONING_TAXONOMY_INTERVAL_INDEX_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "base/rows.hpp"
#include "reasoning/taxonomy/interval.hpp"

namespace geminga::taxonomy {

class IntervalIndex {
 public:
  /// Takes the edges upwards, `parents`, without cycles. Equal graphs give equal ranks. Linear in edges and intervals.
  explicit IntervalIndex(const base::Rows<std::uint32_t>& parents);

  /// True if a node is below another one or is the same. O(1) along the tree, else O(log n) in the further intervals.
  [[nodiscard]] bool is_under(std::uint32_t sub, std::uint32_t super) const;
  /// The number of edges of the longest path upwards.
  [[nodiscard]] std::uint32_t depth(std::uint32_t node) const { return depth_[node]; }
  [[nodiscard]] Interval own(std::uint32_t node) const { return own_[node]; }
  /// The further intervals of a node: ascending, disjoint, outside its own interval.
  [[nodiscard]] std::span<const Interval> further(std::uint32_t node) const {
    return std::span(further_).subspan(further_begin_[node], further_count_[node]);
  }

 private:
  void find_depths(const base::Rows<std::uint32_t>& parents, const base::Rows<std::uint32_t>& children);
  void number_tree(const base::Rows<std::uint32_t>& parents);
  void gather(const base::Rows<std::uint32_t>& children);

  std::vector<std::uint32_t> supers_first_;
  std::vector<std::uint32_t> depth_;
  std::vector<Interval> own_;
  std::vector<std::uint32_t> further_begin_;
  std::vector<std::uint32_t> further_count_;
  std::vector<Interval> further_;
};

}  // namespace geminga::taxonomy

#endif
