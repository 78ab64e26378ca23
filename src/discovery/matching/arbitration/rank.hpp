// The order of the publications that match one subscription.
#ifndef GEMINGA_DISCOVERY_MATCHING_ARBITRATION_RANK_HPP
#define GEMINGA_DISCOVERY_MATCHING_ARBITRATION_RANK_HPP

#include <cstdint>
#include <vector>

#include "discovery/matching/degrees/degree.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// Numbers that say where a candidate stands by its consumer's preferences, the lesser the better (preferences.hpp).
using Score = std::vector<double>;

/// The rank of a candidate. The lesser score comes first, then greater priority, better degree, smaller distance, and
/// the smaller key. All ranks of one subscription have scores of the same length, 0 where it prefers nothing.
struct Rank {
  std::int32_t priority = 0;
  Match match;
  ServiceKey key;
  Score score{};
};

/// Whether `a` is better by more than its key.
[[nodiscard]] bool is_strictly_better(const Rank& a, const Rank& b);
/// Whether `a` may take the place of an incumbent: it is strictly better, and where a number of the scores decides
/// that, the difference is at least the margin of that number. Numbers without margin have 0.
[[nodiscard]] bool is_better_by(const Score& margins, const Rank& a, const Rank& incumbent);

struct BestFirst {
  bool operator()(const Rank& a, const Rank& b) const {
    if (is_strictly_better(a, b)) return true;
    return !is_strictly_better(b, a) && a.key < b.key;
  }
};

}  // namespace geminga::matching

#endif
