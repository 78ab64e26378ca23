// How long a contest about a participant lasts, and when services may lapse in it.
#include "discovery/membership/neighbour/contest.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace geminga::membership {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr base::Instant start{seconds(100)};

TEST(Contest, EndsAtItsInstantAndNotBefore) {
  Contest contest;
  EXPECT_FALSE(contest.is_open());
  EXPECT_EQ(contest.next_deadline(), base::never);
  EXPECT_FALSE(contest.end(start)) << "there is none";
  EXPECT_TRUE(contest.begin(start, start + seconds(10)));
  EXPECT_FALSE(contest.end(start + seconds(10) - milliseconds(1)));
  EXPECT_TRUE(contest.is_open());
  EXPECT_TRUE(contest.end(start + seconds(10)));
  EXPECT_FALSE(contest.is_open());
  EXPECT_EQ(contest.next_deadline(), base::never);
}

TEST(Contest, IsPutOffByTheNextContradictionAndKeepsItsBeginning) {
  Contest contest;
  EXPECT_TRUE(contest.begin(start, start + seconds(10)));
  EXPECT_FALSE(contest.begin(start + seconds(5), start + seconds(15))) << "it has begun already";
  EXPECT_EQ(contest.since(), start);
  EXPECT_FALSE(contest.end(start + seconds(10)));
  contest.prolong(start + seconds(12));
  EXPECT_TRUE(contest.end(start + seconds(15))) << "an earlier instant prolongs nothing";
  EXPECT_TRUE(contest.begin(start + seconds(20), start + seconds(30)));
  EXPECT_EQ(contest.since(), start + seconds(20));
  contest.prolong(start + seconds(31));
  EXPECT_FALSE(contest.end(start + seconds(30)));
  EXPECT_TRUE(contest.end(start + seconds(31)));
}

TEST(Contest, LetsServicesLapseWhileItLasts) {
  Contest contest;
  EXPECT_FALSE(contest.is_lapse_due(start));
  EXPECT_TRUE(contest.begin(start, start + seconds(10)));
  EXPECT_TRUE(contest.is_lapse_due(start)) << "what nobody repeats may lapse at once";
  contest.set_next_lapse(start + seconds(3));
  EXPECT_FALSE(contest.is_lapse_due(start + seconds(3) - milliseconds(1)));
  EXPECT_TRUE(contest.is_lapse_due(start + seconds(3)));
  EXPECT_EQ(contest.next_deadline(), start + seconds(3));
  contest.set_next_lapse(base::never);
  EXPECT_EQ(contest.next_deadline(), start + seconds(10));
  EXPECT_TRUE(contest.end(start + seconds(10)));
  EXPECT_FALSE(contest.is_lapse_due(start + seconds(20)));
}

}  // namespace
}  // namespace geminga::membership
