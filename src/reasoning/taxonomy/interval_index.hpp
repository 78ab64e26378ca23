// "Is A under B" in a directed acyclic graph: preorder ranks of a spanning tree, and lists of intervals for the rest.
//
// Every node has a rank, and what lies below it in the tree has the ranks behind it up to its end (Agrawal, Borgida,
// Jagadish 1989). What lies below it by other edges is kept as further intervals of ranks, merged where they touch.
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
  /// `parents` are the edges up, without cycles; equal graphs give equal numbers. Linear in edges and intervals.
  explicit IntervalIndex(const base::Rows<std::uint32_t>& parents);

  /// Reflexive. O(1) in the tree, O(log n) in the number of intervals beyond.
  [[nodiscard]] bool is_under(std::uint32_t sub, std::uint32_t super) const;
  /// Edges of the longest way up.
  [[nodiscard]] std::uint32_t depth(std::uint32_t node) const { return depth_[node]; }
  [[nodiscard]] Interval own(std::uint32_t node) const { return own_[node]; }
  /// Ascending, disjoint, outside the own interval.
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
