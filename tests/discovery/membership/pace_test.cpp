// The pace where many share the air.
#include "discovery/membership/schedule/pace.hpp"

#include <gtest/gtest.h>

#include "discovery/membership/schedule/schedule.hpp"
#include "discovery/membership/table_rig.hpp"

namespace geminga::membership {
namespace {

TEST(Pace, BoundsWhatAGroupSaysInAnInterval) {
  for (std::size_t others = 0; others <= announcement::max_participants; ++others) {
    std::uint8_t doublings = 0;
    for (int step = 0; step < 10; ++step) doublings = doublings_for(others, doublings);
    const auto intervals = std::size_t{1} << doublings;
    EXPECT_LE(others, intervals * unhurried_participants) << others;
    EXPECT_TRUE(intervals == 1 || 2 * others > intervals * unhurried_participants) << others;
  }
}

TEST(Pace, DoesNotSwingWhereSomebodyComesAndGoes) {
  EXPECT_EQ(doublings_for(65, 0), 1);
  EXPECT_EQ(doublings_for(64, 1), 1);
  EXPECT_EQ(doublings_for(49, 1), 1);
  EXPECT_EQ(doublings_for(48, 1), 0);
  EXPECT_EQ(doublings_for(10, 4), 0);
  EXPECT_EQ(doublings_for(1000, 1), 2) << "one step after the other";
}

TEST(Pace, SaysSixTimesThatItWillSpeakLessOften) {
  Schedule schedule({}, 7);
  auto now = rig_start;
  const auto next = [&] {
    const auto before = now;
    now = schedule.due();
    EXPECT_NE(schedule.take(now), Schedule::Say::nothing);
    return now - before;
  };
  schedule.changed(Schedule::Say::state, now);
  for (int i = 0; i < 20; ++i) (void)next();
  schedule.set_doublings(2, now);
  for (int i = 0; i < 6; ++i) EXPECT_LT(next(), seconds(3)) << i;
  EXPECT_FALSE(schedule.is_slowing());
  for (int i = 0; i < 3; ++i) EXPECT_GT(next(), seconds(7)) << i;
  schedule.set_doublings(0, now);
  EXPECT_LT(next(), seconds(3)) << "more often is at once";
}

TEST(Pace, IsBelievedDoublingByDoublingWhenItWasSaidForAnInterval) {
  TableRig rig;
  auto now = rig_start;
  for (int i = 0; i < 5; ++i) (void)rig.hear(speaker(1, 1), now += seconds(2));
  auto presence = speaker(1, 1, {});
  presence.kind = announcement::Kind::presence;
  presence.peers.clear();
  presence.doublings = 3;
  (void)rig.hear(presence, now += seconds(2));
  EXPECT_LT(rig.table.neighbours().find(ParticipantId{1})->deadline, now + seconds(6));
  (void)rig.hear(presence, now += milliseconds(100));
  EXPECT_LT(rig.table.neighbours().find(ParticipantId{1})->deadline, now + seconds(6))
      << "twice, but not for an interval";
  (void)rig.hear(presence, now += seconds(2));
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->interval, seconds(16));
  EXPECT_GT(rig.table.neighbours().find(ParticipantId{1})->deadline, now + seconds(8));
  EXPECT_LT(rig.table.neighbours().find(ParticipantId{1})->deadline, now + seconds(12)) << "twice the old one";
  (void)rig.hear(presence, now += seconds(4));
  EXPECT_GT(rig.table.neighbours().find(ParticipantId{1})->deadline, now + seconds(16));
  (void)rig.hear(presence, now += seconds(8));
  EXPECT_GT(rig.table.neighbours().find(ParticipantId{1})->deadline, now + seconds(32));
}

TEST(Pace, NeverBringsAnIntervalBeyondItsLimit) {
  EXPECT_EQ(announcement::stretched(seconds(2), 4), seconds(32));
  EXPECT_EQ(announcement::stretched(seconds(2), announcement::max_doublings), announcement::max_interval);
  EXPECT_EQ(announcement::stretched(announcement::max_interval, 1), announcement::max_interval);
}

}  // namespace
}  // namespace geminga::membership
