// The spanning tree is numbered and the intervals are gathered without recursion.
#include "reasoning/taxonomy/interval_index.hpp"

#include <algorithm>

namespace geminga::taxonomy {
namespace {

base::Rows<std::uint32_t> turned_around(const base::Rows<std::uint32_t>& parents) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  pairs.reserve(parents.item_count());
  for (std::uint32_t node = 0; node < parents.row_count(); ++node) {
    for (const std::uint32_t parent : parents[node]) pairs.emplace_back(parent, node);
  }
  return {parents.row_count(), pairs};
}

}  // namespace

IntervalIndex::IntervalIndex(const base::Rows<std::uint32_t>& parents) {
  const base::Rows<std::uint32_t> children = turned_around(parents);
  find_depths(parents, children);
  number_tree(parents);
  gather(children);
}

bool IntervalIndex::is_under(std::uint32_t sub, std::uint32_t super) const {
  const std::uint32_t rank = own_[sub].first;
  if (own_[super].first <= rank && rank <= own_[super].last) return true;
  return contains_rank(further(super), rank);
}

void IntervalIndex::find_depths(const base::Rows<std::uint32_t>& parents, const base::Rows<std::uint32_t>& children) {
  const auto count = static_cast<std::uint32_t>(parents.row_count());
  depth_.assign(count, 0);
  std::vector<std::uint32_t> waiting(count);
  for (std::uint32_t node = 0; node < count; ++node) {
    waiting[node] = static_cast<std::uint32_t>(parents[node].size());
    if (waiting[node] == 0) supers_first_.push_back(node);
  }
  for (std::size_t at = 0; at < supers_first_.size(); ++at) {
    const std::uint32_t node = supers_first_[at];
    for (const std::uint32_t child : children[node]) {
      depth_[child] = std::max(depth_[child], depth_[node] + 1);
      if (--waiting[child] == 0) supers_first_.push_back(child);
    }
  }
}

void IntervalIndex::number_tree(const base::Rows<std::uint32_t>& parents) {
  const auto count = static_cast<std::uint32_t>(parents.row_count());
  // The tree takes the deepest parent. No other parent lies below it, so this edge is one of the reduced graph.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> tree;
  std::vector<std::uint32_t> stack;
  for (std::uint32_t node = count; node-- > 0;) {
    const auto ups = parents[node];
    if (ups.empty()) {
      stack.push_back(node);
      continue;
    }
    std::uint32_t best = ups.front();
    for (const std::uint32_t up : ups) {
      if (depth_[up] > depth_[best] || (depth_[up] == depth_[best] && up < best)) best = up;
    }
    tree.emplace_back(best, node);
  }
  const base::Rows<std::uint32_t> tree_children(count,
                                                tree);  // descending, so that the smallest leaves the stack first
  own_.assign(count, {});
  std::vector<std::uint32_t> preorder;
  preorder.reserve(count);
  std::vector<std::uint32_t> size(count, 1);
  while (!stack.empty()) {
    const std::uint32_t node = stack.back();
    stack.pop_back();
    own_[node].first = static_cast<std::uint32_t>(preorder.size());
    preorder.push_back(node);
    for (const std::uint32_t child : tree_children[node]) stack.push_back(child);
  }
  for (std::size_t at = preorder.size(); at-- > 0;) {
    const std::uint32_t node = preorder[at];
    for (const std::uint32_t child : tree_children[node]) size[node] += size[child];
    own_[node].last = own_[node].first + size[node] - 1;
  }
}

void IntervalIndex::gather(const base::Rows<std::uint32_t>& children) {
  further_begin_.assign(own_.size(), 0);
  further_count_.assign(own_.size(), 0);
  std::vector<Interval> gathered;
  for (std::size_t at = supers_first_.size(); at-- > 0;) {
    const std::uint32_t node = supers_first_[at];
    const Interval own = own_[node];
    const auto take = [&](Interval interval) {
      if (interval.first < own.first || interval.last > own.last) gathered.push_back(interval);
    };
    gathered.clear();
    for (const std::uint32_t child : children[node]) {
      take(own_[child]);
      for (const Interval interval : further(child)) take(interval);
    }
    std::ranges::sort(gathered);
    further_begin_[node] = static_cast<std::uint32_t>(further_.size());
    for (const Interval interval : gathered) {
      const bool is_first = further_.size() == further_begin_[node];
      // Intervals that touch are merged, but not across the node's own interval, which is kept by itself.
      if (!is_first && interval.first <= further_.back().last + 1 &&
          !(further_.back().last < own.first && interval.first > own.last)) {
        further_.back().last = std::max(further_.back().last, interval.last);
      } else {
        further_.push_back(interval);
      }
    }
    further_count_[node] = static_cast<std::uint32_t>(further_.size()) - further_begin_[node];
  }
}

}  // namespace geminga::taxonomy
