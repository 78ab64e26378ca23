#include "discovery/membership/schedule/search.hpp"

#include <gtest/gtest.h>

#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/table_rig.hpp"

namespace geminga::membership {
namespace {

using base::Instant;

constexpr Instant lost{seconds(100)};
constexpr base::Duration interval = seconds(2);

TEST(Search, IsForNobodyUntilSomebodyIsLost) {
  Search search;
  EXPECT_EQ(search.spacing(4, interval, lost), std::nullopt);
}

TEST(Search, LetsOneOfThoseWhoAreLeftSpeakInATenthOfASecond) {
  Search search;
  search.begin(9, lost);
  EXPECT_EQ(search.spacing(4, interval, lost), milliseconds(500));
  EXPECT_EQ(search.spacing(0, interval, lost), milliseconds(100));
}

TEST(Search, SlowsDownAndEndsWhenTheUsualIntervalIsReached) {
  Search search;
  search.begin(9, lost);
  EXPECT_EQ(search.spacing(4, interval, lost + search_slows_in - milliseconds(1)), milliseconds(500));
  EXPECT_EQ(search.spacing(4, interval, lost + search_slows_in), milliseconds(1000));
  EXPECT_EQ(search.spacing(4, interval, lost + 2 * search_slows_in), milliseconds(1500));
  EXPECT_EQ(search.spacing(4, interval, lost + 3 * search_slows_in), std::nullopt);
  EXPECT_EQ(search.spacing(0, interval, lost + 3 * search_slows_in), std::nullopt) << "it has ended";
}

TEST(Search, EndsWhenAsManyAreKnownAsBefore) {
  Search search;
  search.begin(9, lost);
  EXPECT_TRUE(search.spacing(8, interval, lost));
  EXPECT_EQ(search.spacing(9, interval, lost), std::nullopt);
  EXPECT_EQ(search.spacing(8, interval, lost), std::nullopt);
}

TEST(Search, OfALargeTeamIsNotNeeded) {
  Search search;
  search.begin(30, lost);
  EXPECT_EQ(search.spacing(19, interval, lost), std::nullopt) << "somebody speaks in that time anyway";
  search.begin(30, lost);
  EXPECT_EQ(search.spacing(18, interval, lost), milliseconds(1900));
}

TEST(Search, OfMoreWhoAreLostMeanwhileGoesOnAndDoesNotBeginAnew) {
  Search search;
  search.begin(9, lost);
  (void)search.spacing(8, interval, lost);
  search.begin(8, lost + search_slows_in);
  EXPECT_EQ(search.spacing(7, interval, lost + search_slows_in), milliseconds(1600));
}

TEST(Search, IsForWhomTheTableLosesThatMayComeBackIntoReach) {
  TableRig rig;
  for (const std::uint32_t id : {1U, 2U, 3U}) (void)rig.hear(speaker(id, 1));
  (void)rig.hear(speaker(1, 1), rig_start + sought_after);
  (void)rig.hear(speaker(2, 1), rig_start + sought_after - milliseconds(1));
  EXPECT_EQ(rig.table.expire(rig_start + sought_after), 0U) << "who was heard once may have been a forgery";
  EXPECT_EQ(rig.table.neighbours().size(), 2U);
  EXPECT_EQ(rig.table.expire(rig_start + seconds(60)), 1U);
  EXPECT_EQ(rig.table.neighbours().size(), 0U);
}

}  // namespace
}  // namespace geminga::membership
