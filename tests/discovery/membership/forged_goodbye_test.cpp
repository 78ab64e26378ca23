// Forged goodbyes, and the datagrams that follow them.
#include <gmock/gmock.h>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/forged_rig.hpp"

namespace geminga::membership {
namespace {

using ::testing::IsEmpty;

announcement::Announcement goodbye_of(const Air& air) {
  auto goodbye = speaker(1, 0, {});
  goodbye.kind = announcement::Kind::goodbye;
  goodbye.peers.clear();
  goodbye.sequence = air.sequence + 1;
  return goodbye;
}

TEST(Forged, GoodbyeFromAnotherAddressIsIgnored) {
  Air air;
  (void)air.say();
  for (int i = 0; i < 5; ++i) EXPECT_EQ(air.hear(goodbye_of(air), "10.0.0.66"), Hearing::elsewhere);
  EXPECT_TRUE(air.is_right());
}

TEST(Forged, GoodbyeIsUndoneByTheFirstDatagramAfterIt) {
  for (const std::uint64_t step : {0U, 1U, 2U, 1000U}) {
    Air air;
    for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
    auto goodbye = goodbye_of(air);
    goodbye.sequence = air.sequence + step;
    EXPECT_EQ(air.hear(goodbye, "10.0.0.1"), Hearing::goodbye);
    EXPECT_THAT(air.registry.services, IsEmpty());
    air.pass(announcement::overtaken_time);
    EXPECT_EQ(air.say(), Hearing::returned) << step;
    EXPECT_TRUE(air.is_right()) << step;
  }
}

TEST(Forged, GoodbyeWithTheNextNumberIsUndoneAtOnce) {
  Air air;
  (void)air.say();
  EXPECT_EQ(air.hear(goodbye_of(air), "10.0.0.1"), Hearing::goodbye);
  EXPECT_EQ(air.say(), Hearing::returned);
  EXPECT_TRUE(air.is_right());
}

TEST(Forged, GoodbyesEverySecondHideNobodyAfterTheFirst) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  (void)air.hear(goodbye_of(air), "10.0.0.1");
  air.pass(seconds(1));
  (void)air.say();
  for (int i = 1; i <= 120; ++i) {
    EXPECT_EQ(air.hear(goodbye_of(air), "10.0.0.1"), Hearing::contradiction);
    air.pass(seconds(1));
    if (i % 2 == 0) (void)air.say();
    EXPECT_TRUE(air.is_right()) << i;
  }
  // A true goodbye is believed then if nothing follows it for two intervals.
  (void)air.hear(goodbye_of(air), "10.0.0.1");
  air.pass(2 * interval);
  EXPECT_FALSE(air.rig.table.neighbours().is_known(victim));
  EXPECT_THAT(air.registry.services, IsEmpty());
}

TEST(Forged, LifeUnderAKnownIdentifierAfterAForgedGoodbyeGivesWayToTheTrueOne) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  (void)air.hear(goodbye_of(air), "10.0.0.1");
  auto usurper = air.truth();
  usurper.boot = announcement::BootNonce{66};
  EXPECT_EQ(air.hear(usurper, "10.0.0.66"), Hearing::newcomer);
  air.pass(seconds(1));
  EXPECT_EQ(air.say(), Hearing::returned);
  for (int i = 0; i < 100; ++i) {
    // A datagram right after the loss of the identifier may have been sent before it.
    EXPECT_EQ(air.hear(usurper, "10.0.0.66"), i == 0 ? Hearing::stale : Hearing::rival);
    if (i % 10 == 0) (void)air.say();
    air.pass(milliseconds(200));
    EXPECT_TRUE(air.is_right());
  }
}

}  // namespace
}  // namespace geminga::membership
