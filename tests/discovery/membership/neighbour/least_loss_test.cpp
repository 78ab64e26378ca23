// The loss that a sample bears out, at its edges and over many samples.
#include "discovery/membership/neighbour/least_loss.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "discovery/membership/neighbour/neighbour.hpp"

namespace geminga::membership {
namespace {

/// The loss that deadlines bear (tools/doctor/checks.hpp, examples/monitoring/geminga.rules.yml).
constexpr double bearable = 0.4;

TEST(LeastLoss, IsTheBoundOfClopperAndPearson) {
  // Table values: with error e, n of n missed give the n-th root of e.
  EXPECT_NEAR(least_loss(LossSample{.missed = 1, .numbers = 1}, 0.05), 0.05, 1e-9);
  EXPECT_NEAR(least_loss(LossSample{.missed = 10, .numbers = 10}, 0.025), 0.69150, 1e-5);
  EXPECT_NEAR(least_loss(LossSample{.missed = 5, .numbers = 10}, 0.025), 0.18709, 1e-5);
  EXPECT_EQ(least_loss(LossSample{.missed = 0, .numbers = 64}, 0.025), 0);
}

TEST(LeastLoss, NeedsSoManyMissedNumbersToBeAboveWhatDeadlinesBear) {
  // The binomial distribution's own sums: P(missed >= k | 40 %) <= 0.00005.
  struct Edge {
    int numbers;
    int missed;
  };
  for (const auto& [numbers, missed] : {Edge{12, 12}, Edge{16, 15}, Edge{24, 20}, Edge{32, 25}, Edge{64, 42}}) {
    const auto least = [n = numbers](int lost) {
      const LossSample sample{.missed = lost, .numbers = n};
      return least_loss(sample, sample);
    };
    EXPECT_GT(least(missed), bearable) << missed << " of " << numbers;
    EXPECT_LE(least(missed - 1), bearable) << missed << " of " << numbers;
  }
  const LossSample lately{.missed = 30, .numbers = 64};
  EXPECT_GT(least_loss(lately, {.missed = 134, .numbers = 256}), bearable) << "a long sample shows a smaller excess";
  EXPECT_LE(least_loss(lately, {.missed = 133, .numbers = 256}), bearable);
  EXPECT_LE(least_loss({.missed = 25, .numbers = 64}, {.missed = 200, .numbers = 256}), bearable)
      << "a link that was mended is believed";
  for (int missed = 0; missed < 12; ++missed)
    EXPECT_LE(least_loss({.missed = missed, .numbers = 12}, {.missed = missed, .numbers = 12}), bearable);
}

TEST(LeastLoss, IsZeroWithoutAWayOrWhereARelayTellsTheLoss) {
  EXPECT_EQ(least_loss(Neighbour{}), 0);
  Neighbour neighbour;
  neighbour.paths.resize(1);
  neighbour.paths[0].loss = 0.9;
  EXPECT_EQ(least_loss(neighbour), 0);
  neighbour.paths[0].lately = neighbour.paths[0].for_long = {.missed = 60, .numbers = 64};
  EXPECT_GT(least_loss(neighbour), bearable);
  neighbour.paths.push_back(neighbour.paths[0]);
  neighbour.paths[1].lately = neighbour.paths[1].for_long = {.missed = 0, .numbers = 64};
  EXPECT_EQ(least_loss(neighbour), 0) << "the better way counts";
}

/// How many of 10 000 links of this loss are taken for worse than deadlines bear, when so many numbers were said.
int found_bad(double loss, std::uint64_t numbers, std::uint64_t seed) {
  base::Random random(seed);
  int found = 0;
  for (int link = 0; link < 10000; ++link) {
    LossWindow window;
    window.count(0);
    for (std::uint64_t number = 1; number < numbers; ++number) {
      if (!random.chance(loss)) window.count(number);
    }
    if (window.loss() > bearable && least_loss(window.lately(), window.for_long()) > bearable) ++found;
  }
  return found;
}

TEST(LeastLoss, TakesNoHealthyLinkForABadOne) {
  for (const std::uint64_t numbers : {4U, 16U, 64U, 300U}) {
    EXPECT_EQ(found_bad(0.3, numbers, 1 + numbers), 0) << numbers << " numbers";
    EXPECT_LE(found_bad(bearable, numbers, 2 + numbers), 4) << "one in ten thousand is allowed; seed " << 2 + numbers;
  }
}

TEST(LeastLoss, FindsABadLink) {
  EXPECT_GT(found_bad(0.75, 64, 3), 8500);
  EXPECT_GT(found_bad(0.6, 256, 4), 9500);
}

}  // namespace
}  // namespace geminga::membership
