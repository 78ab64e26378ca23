// Numbers that were overtaken, and numbers that come too late.
#include "discovery/membership/neighbour/rising_count.hpp"

#include <gtest/gtest.h>

namespace geminga::membership {
namespace {

using announcement::overtaken_time;

constexpr base::Instant start{std::chrono::seconds(1000)};

TEST(RisingCount, TakesALowerNumberForOvertakenUntilItsTimeIsOver) {
  RisingCount count(10, start);
  count.rise(12, start + overtaken_time);
  EXPECT_FALSE(count.is_late(11, start + 2 * overtaken_time - base::Duration(1)));
  EXPECT_TRUE(count.is_late(11, start + 2 * overtaken_time));
  EXPECT_FALSE(count.is_late(12, start + 2 * overtaken_time)) << "the newest number itself";
}

TEST(RisingCount, FindsALateNumberThoughTheCountGoesOnRising) {
  RisingCount count(1, start);
  auto now = start;
  for (std::uint64_t number = 2; number <= 100; ++number) count.rise(number, now += overtaken_time / 10);
  EXPECT_TRUE(count.is_late(75, now));
  EXPECT_FALSE(count.is_late(95, now));
}

TEST(RisingCount, BeginsAnewFromALowerNumber) {
  RisingCount count(100, start);
  count.restart(5, start + overtaken_time);
  EXPECT_FALSE(count.is_late(6, start + overtaken_time));
}

}  // namespace
}  // namespace geminga::membership
