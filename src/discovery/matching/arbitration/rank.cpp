#include "discovery/matching/arbitration/rank.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace geminga::matching {
namespace {

/// How far the difference of two numbers may be off because doubles are rounded: 0.15 - 0.1 is a little less than 0.05.
double noise(double a, double b) {
  constexpr double rounding = 1e-12;
  return rounding * std::max(std::abs(a), std::abs(b));
}

}  // namespace

bool is_strictly_better(const Rank& a, const Rank& b) {
  const bool has_score = !a.score.empty() || !b.score.empty();  // asked first, because few have a score
  if (has_score && a.score != b.score) return a.score < b.score;
  if (a.priority != b.priority) return a.priority > b.priority;
  return a.match < b.match;
}

bool is_better_by(const Score& margins, const Rank& a, const Rank& incumbent) {
  if (!is_strictly_better(a, incumbent)) return false;
  const auto [its, others] = std::ranges::mismatch(a.score, incumbent.score);
  const auto place = static_cast<std::size_t>(its - a.score.begin());
  if (its == a.score.end() || others == incumbent.score.end() || place >= margins.size()) return true;
  return *others - *its >= margins[place] - noise(*others, *its);
}

}  // namespace geminga::matching
