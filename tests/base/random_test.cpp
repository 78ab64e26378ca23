#include "base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace geminga::base {
namespace {

TEST(Random, TheSameSeedGivesTheSameSequence) {
  Random a(7);
  Random b(7);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(a.next(), b.next());
}

TEST(Random, IsTheReferenceSequenceOfSplitmixAndXoshiro) {
  // splitmix64(0) begins with e220a8397b1dcdaf, 6e789e6aa1b965f4, ...: the reference states of xoshiro256** for seed 0.
  Random random(0);
  EXPECT_EQ(random.next(), 0x99ec5f36cb75f2b4U);
  EXPECT_EQ(random.next(), 0xbf6e1f784956452aU);
}

TEST(Random, StaysBelowItsBoundAndReachesEveryValue) {
  Random random(1);
  std::array<int, 7> seen{};
  for (int i = 0; i < 7000; ++i) ++seen.at(random.below(7));
  EXPECT_GT(*std::ranges::min_element(seen), 800);
}

TEST(Random, DurationsIncludeBothEnds) {
  Random random(2);
  bool low = false;
  bool high = false;
  for (int i = 0; i < 100; ++i) {
    const Duration d = random.between(Duration(3), Duration(5));
    ASSERT_GE(d, Duration(3));
    ASSERT_LE(d, Duration(5));
    low |= d == Duration(3);
    high |= d == Duration(5);
  }
  EXPECT_TRUE(low && high);
}

}  // namespace
}  // namespace geminga::base
