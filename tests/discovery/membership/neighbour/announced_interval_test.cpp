// What somebody must say, and for how long, before another interval counts.
#include "discovery/membership/neighbour/announced_interval.hpp"

#include <gtest/gtest.h>

namespace geminga::membership {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr base::Instant start{seconds(1000)};
constexpr base::Duration hold = seconds(4);

TEST(AnnouncedInterval, ThatIsLongerCountsAfterAnOldOneWithWordsAtTheOldPace) {
  AnnouncedInterval interval(seconds(2), start);
  for (int word = 0; word < 100; ++word) interval.say(seconds(60), start + milliseconds(word), hold, false);
  EXPECT_EQ(interval.value(), seconds(60));
  EXPECT_EQ(interval.lasting(start + milliseconds(100)), seconds(2));
  EXPECT_EQ(interval.lasting(start + seconds(100)), seconds(2)) << "silence proves nothing";
  interval.say(seconds(60), start + milliseconds(1'700), hold, false);
  EXPECT_EQ(interval.lasting(start + milliseconds(1'700)), seconds(4)) << "and twice as long at most";
  interval.say(seconds(60), start + milliseconds(4'500), hold, false);
  EXPECT_EQ(interval.lasting(start + milliseconds(4'500)), seconds(4));
  interval.say(seconds(60), start + seconds(5), hold, false);
  EXPECT_EQ(interval.lasting(start + seconds(5)), seconds(8));
}

TEST(AnnouncedInterval, ThatIsLongerIsForgottenWhenTheOldOneIsSaidBetween) {
  AnnouncedInterval interval(seconds(2), start);
  interval.say(seconds(4), start, hold, false);
  interval.say(seconds(2), start + seconds(1), hold, false);
  interval.say(seconds(4), start + seconds(2), hold, false);
  EXPECT_EQ(interval.lasting(start + seconds(2)), seconds(2));
}

TEST(AnnouncedInterval, ThatIsShorterCountsAfterTwoOldOnes) {
  AnnouncedInterval interval(seconds(2), start);
  interval.say(milliseconds(50), start, hold, false);
  EXPECT_EQ(interval.lasting(start + milliseconds(3'999)), seconds(2));
  EXPECT_EQ(interval.lasting(start + seconds(4)), milliseconds(50));
  interval.say(milliseconds(50), start + seconds(5), hold, false);
  EXPECT_EQ(interval.lasting(start + seconds(5)), milliseconds(50));
  interval.say(seconds(2), start + seconds(6), hold, false);
  EXPECT_EQ(interval.lasting(start + seconds(6)), milliseconds(50)) << "it is a longer one now";
}

}  // namespace
}  // namespace geminga::membership
