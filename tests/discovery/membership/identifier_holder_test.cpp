// The holder of an identifier under which several speak: the incarnation that was heard first, and none for good.
#include <gmock/gmock.h>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/forged_rig.hpp"

namespace geminga::membership {
namespace {

constexpr const char* stranger = "10.0.0.66";
constexpr const char* own = "10.0.0.1";

announcement::Announcement incarnation(announcement::BootNonce boot, std::uint32_t id = 1) {
  auto state = speaker(id, 1, {9});
  state.boot = boot;
  state.name = "liar";
  return state;
}

announcement::Announcement as(announcement::Kind kind, announcement::Announcement announcement) {
  announcement.kind = kind;
  announcement.peers.clear();
  return announcement;
}

/// The victim goes on speaking, and another sender says this five times a second.
void expect_right_while_repeated(Air& air, const announcement::Announcement& lie, const std::string& source) {
  for (int i = 0; i < 100; ++i) {
    (void)air.hear(lie, source);
    if (i % 10 == 0) (void)air.say();
    air.pass(milliseconds(200));
    EXPECT_TRUE(air.is_right()) << i << testing::PrintToString(air.registry.services);
  }
}

TEST(Identifier, IsNotGivenToAStrangerThatWasKnownForLongerThanItsOwnerUnderAnotherOne) {
  Air air;
  const announcement::BootNonce decoy{66};
  for (int i = 0; i < 2; ++i, air.pass(seconds(1))) (void)air.hear(incarnation(decoy, 77), stranger);
  for (int i = 0; i < 5; ++i, air.pass(interval)) {
    (void)air.hear(incarnation(decoy, 77), stranger);
    (void)air.say();
  }
  EXPECT_EQ(air.hear(as(announcement::Kind::goodbye, incarnation(decoy, 77)), stranger), Hearing::goodbye);
  EXPECT_EQ(air.hear(incarnation(decoy), stranger), Hearing::rival);
  expect_right_while_repeated(air, incarnation(decoy), stranger);
}

TEST(Identifier, IsNotGivenToAUsurperThatSaysGoodbyeAndComesBack) {
  for (const auto* source : {stranger, own}) {
    Air air;
    const auto usurper = incarnation(announcement::BootNonce{66});
    for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
    (void)air.hear(as(announcement::Kind::goodbye, speaker(1, 0, {})), own);
    EXPECT_EQ(air.hear(usurper, source), Hearing::newcomer);
    EXPECT_EQ(air.hear(as(announcement::Kind::goodbye, usurper), source), Hearing::goodbye);
    air.pass(seconds(1));
    EXPECT_EQ(air.say(), Hearing::returned) << source;
    air.pass(seconds(1));
    EXPECT_EQ(air.hear(usurper, source), Hearing::rival) << source;
    expect_right_while_repeated(air, usurper, source);
  }
}

TEST(Identifier, IsGivenBackToWhoeverWasSilentForTwoIntervals) {
  Air air;
  const auto usurper = incarnation(announcement::BootNonce{66});
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  air.pass(interval);  // two since its last word
  (void)air.hear(usurper, stranger);
  EXPECT_EQ(air.hear(usurper, stranger), Hearing::newcomer);
  air.pass(interval);
  EXPECT_EQ(air.say(), Hearing::returned);
  expect_right_while_repeated(air, usurper, stranger);
}

TEST(Identifier, IsTheFirstClaimantsAndNotThatOfWhoeverAnticipatesItsFirstState) {
  for (const auto* source : {stranger, own}) {
    for (const auto boot : {announcement::BootNonce{66}, announcement::BootNonce{1}}) {
      if (boot == announcement::BootNonce{1} && source == own)
        continue;  // the same incarnation: each word of it is weighed
      Air air;
      (void)air.hear(as(announcement::Kind::claim, speaker(1, 0, {})), own);
      for (int i = 0; i < 5; ++i, air.pass(milliseconds(20))) (void)air.hear(incarnation(boot), source);
      EXPECT_EQ(air.say(), Hearing::newcomer) << source;
      EXPECT_TRUE(air.is_right()) << source;
      // With its own boot nonce it is a move to another address, which is undone when the first address speaks.
      for (int i = 0; boot == announcement::BootNonce{1} && i < 30; ++i, air.pass(milliseconds(200))) {
        (void)air.hear(incarnation(boot), source);
        if (i % 10 == 0) (void)air.say();
      }
      expect_right_while_repeated(air, incarnation(boot), source);
    }
  }
}

TEST(Identifier, IsTheFirstClaimantsThoughSomebodySaidHelloAndGoodbyeWithItsBootNonce) {
  Air air;
  (void)air.hear(as(announcement::Kind::claim, speaker(1, 0, {})), own);
  (void)air.hear(incarnation(announcement::BootNonce{1}), stranger);
  (void)air.hear(as(announcement::Kind::goodbye, incarnation(announcement::BootNonce{1})), stranger);
  EXPECT_EQ(air.say(), Hearing::newcomer);
  EXPECT_TRUE(air.is_right());
}

TEST(Identifier, IsTheFirstClaimantsThoughItsClaimIsOvertakenByAnAnswerToIt) {
  for (const auto boot : {announcement::BootNonce{66}, announcement::BootNonce{1}}) {
    for (const auto late :
         {announcement::overtaken_time - base::Duration(1), base::Duration(announcement::overtaken_time)}) {
      Air air;
      (void)air.hear(incarnation(boot), stranger);
      air.pass(late);
      (void)air.hear(as(announcement::Kind::claim, speaker(1, 0, {})), own);
      EXPECT_EQ(air.say() == Hearing::newcomer, late < announcement::overtaken_time);
      EXPECT_EQ(air.is_right(), late < announcement::overtaken_time);
    }
  }
}

TEST(Identifier, IsNotGivenToAClaimThatWasMadeWhileSomebodyHadIt) {
  Air air;
  const auto usurper = incarnation(announcement::BootNonce{66});
  for (int i = 0; i < 5; ++i, air.pass(interval)) {
    (void)air.say();
    (void)air.hear(as(announcement::Kind::claim, usurper), stranger);
  }
  expect_right_while_repeated(air, usurper, stranger);
}

TEST(Identifier, IsGivenBackThoughAHundredsOfOthersHaveLeftMeanwhile) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  (void)air.hear(as(announcement::Kind::goodbye, speaker(1, 0, {})), own);
  for (std::uint32_t id = 1000; id < 1000 + 2 * announcement::max_participants; ++id) {
    (void)air.hear(incarnation(announcement::BootNonce{id}, id), stranger);
    (void)air.hear(as(announcement::Kind::goodbye, incarnation(announcement::BootNonce{id}, id)), stranger);
  }
  (void)air.hear(incarnation(announcement::BootNonce{66}), stranger);
  air.pass(seconds(1));
  EXPECT_EQ(air.say(), Hearing::returned);
  EXPECT_TRUE(air.is_right());
}

TEST(Identifier, OfALongIntervalIsGivenBackWithinIt) {
  Air air;
  const auto say = [&] {
    auto state = air.truth();
    state.interval = announcement::max_interval;
    return air.say(state);
  };
  (void)say();
  for (int i = 0; i < 5; ++i, air.pass(announcement::max_interval)) (void)say();
  (void)air.hear(as(announcement::Kind::goodbye, speaker(1, 0, {})), own);
  (void)air.hear(incarnation(announcement::BootNonce{66}), stranger);
  air.pass(announcement::max_interval - seconds(4));
  (void)air.hear(incarnation(announcement::BootNonce{66}), stranger);
  EXPECT_EQ(say(), Hearing::returned);
  EXPECT_TRUE(air.is_right());
}

TEST(Identifier, IsGivenBackThoughTheNextNumbersOfItsOwnerWereForgedBeforeTheGoodbye) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  for (std::uint64_t ahead = 1; ahead <= 60; ++ahead) {
    auto forged = air.truth();
    forged.sequence = air.sequence + ahead;
    (void)air.hear(forged, own);
  }
  auto goodbye = as(announcement::Kind::goodbye, speaker(1, 0, {}));
  goodbye.sequence = air.sequence + 61;
  ASSERT_EQ(air.hear(goodbye, own), Hearing::goodbye);
  air.pass(interval);
  (void)air.say();
  air.pass(interval);
  (void)air.say();
  EXPECT_TRUE(air.is_right());
}

TEST(Identifier, IsGivenBackThoughItsOwnerWasMovedToAnotherAddressBeforeTheGoodbye) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  auto moved = air.truth();
  for (moved.sequence = 100; moved.sequence < 102; ++moved.sequence) (void)air.hear(moved, stranger);
  auto goodbye = as(announcement::Kind::goodbye, speaker(1, 0, {}));
  goodbye.sequence = 102;
  ASSERT_EQ(air.hear(goodbye, stranger), Hearing::goodbye);
  (void)air.hear(incarnation(announcement::BootNonce{66}), stranger);
  air.pass(seconds(1));
  EXPECT_EQ(air.say(), Hearing::returned);
  EXPECT_TRUE(air.is_right());
}

TEST(Identifier, MovesWithItsOwnerToANewAddressThoughSomebodyForgesTheHighestNumberThere) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  auto moved = air.truth();
  moved.revision = 2;
  moved.addresses = {"10.0.0.9"};
  const auto hear = [&](std::uint64_t sequence) {
    moved.sequence = sequence;
    return air.hear(moved, "10.0.0.9");
  };
  (void)hear(~std::uint64_t{0});
  (void)hear(++air.sequence);
  (void)hear(++air.sequence);
  EXPECT_EQ(air.rig.table.neighbours().find(victim)->address, "10.0.0.9");
}

TEST(FormerIncarnations, AreRememberedUpToTheNamedNumberAndTheYoungestGivesWay) {
  for (const auto count :
       {announcement::max_participants - 1, announcement::max_participants, announcement::max_participants + 1}) {
    TableRig rig;
    const auto each = [&](auto visit) {
      for (std::uint32_t id = 1; id <= count; ++id) visit(id);
    };
    std::uint32_t returned = 0;
    each([&](std::uint32_t id) {
      (void)rig.hear(incarnation(announcement::BootNonce{id}, id), rig_start + milliseconds(id));
      (void)rig.hear(as(announcement::Kind::goodbye, incarnation(announcement::BootNonce{id}, id)),
                     rig_start + milliseconds(id));
    });
    each([&](std::uint32_t id) {
      const auto hearing = rig.hear(incarnation(announcement::BootNonce{id}, id), rig_start + seconds(1));
      returned += hearing == Hearing::returned ? 1 : 0;
      EXPECT_EQ(hearing == Hearing::returned, id <= announcement::max_participants) << id;
      (void)rig.hear(as(announcement::Kind::goodbye, incarnation(announcement::BootNonce{id}, id)),
                     rig_start + seconds(1));
    });
    EXPECT_EQ(returned, std::min(count, announcement::max_participants));
  }
}

}  // namespace
}  // namespace geminga::membership
