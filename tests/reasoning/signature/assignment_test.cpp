// The best one-to-one assignment, compared with all assignments.
#include "reasoning/signature/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "base/random.hpp"

namespace geminga::signature {
namespace {

double sum_of(const Worth& worth, const std::vector<std::optional<std::size_t>>& column_of) {
  double sum = 0;
  for (std::size_t row = 0; row < worth.rows(); ++row) {
    if (column_of[row]) sum += worth.at(row, *column_of[row]);
  }
  return sum;
}

/// The best worth of all permutations of the larger side.
double best_sum(const Worth& worth) {
  std::vector<std::size_t> order(std::max(worth.rows(), worth.columns()));
  std::iota(order.begin(), order.end(), 0);
  double best = 0;
  do {
    double sum = 0;
    for (std::size_t at = 0; at < order.size(); ++at) {
      const std::size_t row = worth.rows() <= worth.columns() ? at : order[at];
      const std::size_t column = worth.rows() <= worth.columns() ? order[at] : at;
      if (row < worth.rows() && column < worth.columns()) sum += worth.at(row, column);
    }
    best = std::max(best, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(Assignment, IsTheBestThereIsAndUsesNoColumnTwice) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    base::Random random(seed);
    Worth worth(random.below(6), random.below(6));
    for (std::size_t row = 0; row < worth.rows(); ++row) {
      for (std::size_t column = 0; column < worth.columns(); ++column)
        worth.at(row, column) = static_cast<double>(random.below(5)) / 4;
    }
    const auto column_of = best_assignment(worth);
    ASSERT_EQ(column_of.size(), worth.rows()) << seed;
    EXPECT_NEAR(sum_of(worth, column_of), best_sum(worth), 1e-9) << seed;
    std::set<std::size_t> used;
    for (const auto& column : column_of) {
      if (!column) continue;
      EXPECT_TRUE(used.insert(*column).second) << seed;
    }
    EXPECT_EQ(used.size(), std::min(worth.rows(), worth.columns())) << seed;
  }
}

TEST(Assignment, GivesNothingWhereOneSideIsEmpty) {
  EXPECT_TRUE(best_assignment(Worth(0, 3)).empty());
  EXPECT_EQ(best_assignment(Worth(2, 0)), (std::vector<std::optional<std::size_t>>(2)));
}

}  // namespace
}  // namespace geminga::signature
