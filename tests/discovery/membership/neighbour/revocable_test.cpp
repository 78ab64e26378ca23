// A value that can be taken back.
#include "discovery/membership/neighbour/revocable.hpp"

#include <gtest/gtest.h>

namespace geminga::membership {
namespace {

using std::chrono::seconds;

constexpr base::Instant start{seconds(1000)};
constexpr base::Duration hold = seconds(8);

TEST(Revocable, TakesBackALieThatWasToldInSeveralSteps) {
  Revocable<int> value(1, start);
  value.replace(2, start + seconds(10), hold);
  value.replace(3, start + seconds(12), hold);
  EXPECT_TRUE(value.roll_back(start + seconds(14), hold));
  EXPECT_EQ(value.value(), 1);
  EXPECT_EQ(value.said(), start);
}

TEST(Revocable, KeepsAChangeThatIsAsOldAsTheHold) {
  Revocable<int> value(1, start);
  value.replace(2, start, hold);
  EXPECT_NE(value.former(start + hold - base::Duration(1), hold), nullptr);
  EXPECT_FALSE(value.roll_back(start + hold, hold));
  EXPECT_EQ(value.value(), 2);
}

TEST(Revocable, KnowsWhetherItsValueWasSaidTwice) {
  Revocable<int> value(1, start);
  EXPECT_FALSE(value.is_repeated());
  value.affirm(start + seconds(1));
  EXPECT_TRUE(value.is_repeated());
  EXPECT_TRUE(value.is_held(start + seconds(8), hold));
  EXPECT_FALSE(value.is_held(start + seconds(9), hold));
  value.replace(2, start + seconds(2), hold);
  EXPECT_FALSE(value.is_repeated());
}

}  // namespace
}  // namespace geminga::membership
