// A restarted daemon takes the place of its former incarnation, unless that one shows that it lives.
#include <gmock/gmock.h>

#include "discovery/membership/namesakes.hpp"
#include "discovery/membership/schedule/deadline.hpp"
#include "discovery/membership/table_rig.hpp"

namespace geminga::membership {
namespace {

constexpr ParticipantId former{1};
constexpr const char* address = "10.0.0.1";

announcement::Announcement next_incarnation() {
  auto claim = speaker(2, 0, {});
  claim.kind = announcement::Kind::claim;
  claim.name = "robot1";
  claim.boot = announcement::BootNonce{77};
  return claim;
}

struct Succession : ::testing::Test {
  Succession() {
    rig.source = address;
    for (int i = 0; i < 20; ++i) (void)rig.hear(speaker(1, 1), now = rig_start + i * seconds(2));
    now += milliseconds(700);
  }
  [[nodiscard]] bool is_known_after(base::Duration time) {
    rig.table.expire(now + time);
    return rig.table.neighbours().is_known(former);
  }

  TableRig rig;
  base::Instant now;
};

TEST_F(Succession, OfOneThatDoesNotAnswerIsBelievedAtOnce) {
  ASSERT_EQ(rig.hear(next_incarnation(), now), Hearing::claim);
  EXPECT_THAT(rig.table.report(now).doubts, ::testing::ElementsAre(former));
  EXPECT_TRUE(is_known_after(least_answer_time - base::Duration(1)));
  EXPECT_FALSE(is_known_after(least_answer_time));
}

TEST(YoungSuccession, OfOneThatWasHeardOnceIsBelieved) {
  TableRig rig;
  rig.source = address;
  (void)rig.hear(speaker(1, 1));
  (void)rig.hear(next_incarnation(), rig_start + seconds(1));
  EXPECT_THAT(rig.table.report(rig_start + seconds(1)).doubts, ::testing::ElementsAre(former));
  rig.table.expire(rig_start + seconds(1) + least_answer_time);
  EXPECT_FALSE(rig.table.neighbours().is_known(former));
}

TEST_F(Succession, OfOneThatNobodyAskedIsNotBelievedBeforeItsDeadline) {
  (void)rig.hear(next_incarnation(), now);
  EXPECT_TRUE(is_known_after(seconds(3)));
}

TEST_F(Succession, IsNotTriedAgainWhenItWasWrong) {
  (void)rig.hear(next_incarnation(), now);
  (void)rig.table.report(now);
  ASSERT_FALSE(is_known_after(least_answer_time));
  now += seconds(1);
  EXPECT_EQ(rig.hear(speaker(1, 1), now), Hearing::newcomer) << "it lives, and has not heard the question";
  (void)rig.hear(speaker(1, 1), now + milliseconds(20));
  (void)rig.hear(next_incarnation(), now + seconds(1));
  EXPECT_TRUE(rig.table.report(now + seconds(1)).doubts.empty());
}

TEST_F(Succession, OfOneThatAnswersIsNotBelieved) {
  (void)rig.hear(next_incarnation(), now);
  (void)rig.hear(speaker(1, 1), now + milliseconds(50));
  EXPECT_TRUE(rig.table.report(now + milliseconds(50)).doubts.empty());
  EXPECT_TRUE(is_known_after(seconds(4)));
}

TEST_F(Succession, IsOfTheSameNameFromTheSameAddress) {
  auto other = next_incarnation();
  other.name = "robot2";
  (void)rig.hear(other, now);
  EXPECT_TRUE(rig.table.report(now).doubts.empty()) << "another name";
  rig.source = "10.0.0.9";
  (void)rig.hear(next_incarnation(), now);
  EXPECT_TRUE(rig.table.report(now).doubts.empty()) << "another address";
  rig.source = address;
  auto redrawn = next_incarnation();
  redrawn.boot = speaker(1, 1).boot;
  (void)rig.hear(redrawn, now);
  EXPECT_TRUE(rig.table.report(now).doubts.empty()) << "the same incarnation takes another identifier";
  auto nameless = next_incarnation();
  nameless.name.clear();
  (void)rig.hear(nameless, now);
  EXPECT_TRUE(rig.table.report(now).doubts.empty()) << "nameless";
}

TEST_F(Succession, BeginsWithTheFirstStateWhereTheClaimsWereLost) {
  auto state = next_incarnation();
  state.kind = announcement::Kind::state;
  ASSERT_EQ(rig.hear(state, now), Hearing::newcomer);
  EXPECT_THAT(rig.table.report(now).doubts, ::testing::ElementsAre(former));
}

TEST(Namesakes, FindsThoseOfOneNameAtOneAddressAndNobodyWhereTheyAreMany) {
  Namesakes names;
  for (std::uint32_t id = 1; id <= max_namesakes; ++id) names.update(ParticipantId{id}, {"robot1", address}, 0);
  names.update(ParticipantId{100}, {"robot1", "10.0.0.9"}, 0);
  names.update(ParticipantId{101}, {"robot2", address}, 0);
  EXPECT_EQ(names.find({"robot1", address}, 0).size(), max_namesakes);
  names.update(ParticipantId{101}, {"robot1", address}, 0);
  EXPECT_THAT(names.find({"robot1", address}, 0), ::testing::IsEmpty());
  names.remove(ParticipantId{1});
  EXPECT_EQ(names.find({"robot1", address}, 0).size(), max_namesakes);
  EXPECT_THAT(names.find({"robot2", address}, 0), ::testing::IsEmpty());
}

TEST_F(Succession, IsTriedOnceInFiveIntervalsHoweverOftenItIsClaimed) {
  (void)rig.hear(next_incarnation(), now);
  (void)rig.hear(speaker(1, 1), now + milliseconds(10));
  (void)rig.hear(next_incarnation(), now + milliseconds(20));
  EXPECT_TRUE(rig.table.report(now).doubts.empty());
  (void)rig.hear(speaker(1, 1), now + seconds(10));
  (void)rig.hear(next_incarnation(), now + seconds(10));
  EXPECT_THAT(rig.table.report(now + seconds(10)).doubts, ::testing::ElementsAre(former));
}

TEST(AnswerTime, GrowsWithTheLossAndIsNeverEndless) {
  EXPECT_EQ(answer_time(0), least_answer_time);
  EXPECT_EQ(answer_time(0.37), least_answer_time) << "seven denials are enough";
  EXPECT_EQ(answer_time(0.5), (10 + denials_unprompted) * denial_spacing) << "that are ten";
  const base::Duration all_denials = (denials + denials_unprompted) * denial_spacing;
  EXPECT_EQ(answer_time(0.7), all_denials);
  EXPECT_EQ(answer_time(0.71), all_denials + question_time);
  EXPECT_LT(answer_time(1), seconds(10));
}

TEST(Namesakes, FindsThoseOfOneLastingIdentityWhateverTheyAreCalled) {
  Namesakes names;
  for (std::uint32_t id = 1; id <= max_namesakes; ++id) {
    names.update(ParticipantId{id}, {"robot" + std::to_string(id), address}, 7);
  }
  names.update(ParticipantId{100}, {"", address}, 0);
  names.update(ParticipantId{101}, {"other", address}, 8);
  EXPECT_EQ(names.find({"new", "10.0.0.9"}, 7).size(), max_namesakes);
  EXPECT_EQ(names.find({"robot1", address}, 7).size(), max_namesakes) << "each once";
  EXPECT_THAT(names.find({"other", address}, 7), ::testing::SizeIs(max_namesakes + 1));
  EXPECT_THAT(names.find({"", address}, 0), ::testing::IsEmpty()) << "nothing is no name and no identity";
  names.update(ParticipantId{101}, {"other", address}, 7);
  EXPECT_THAT(names.find({"new", "10.0.0.9"}, 7), ::testing::IsEmpty()) << "copies of one disk, all over a fleet";
  names.remove(ParticipantId{1});
  EXPECT_EQ(names.find({"new", "10.0.0.9"}, 7).size(), max_namesakes);
}

/// A next incarnation at another address, with another name.
announcement::Announcement moved_life(std::uint32_t lasting) {
  auto claim = next_incarnation();
  claim.name = "renamed";
  claim.lasting = lasting;
  return claim;
}

struct LastingSuccession : ::testing::Test {
  LastingSuccession() {
    rig.source = address;
    auto state = speaker(1, 1);
    state.lasting = 7;
    for (int i = 0; i < 20; ++i) (void)rig.hear(state, now = rig_start + i * seconds(2));
    now += milliseconds(700);
    rig.source = "10.0.0.9";
  }
  TableRig rig;
  base::Instant now;
};

TEST_F(LastingSuccession, IsOfAnyNameFromAnyAddress) {
  ASSERT_EQ(rig.hear(moved_life(7), now), Hearing::claim);
  EXPECT_THAT(rig.table.report(now).doubts, ::testing::ElementsAre(former));
  rig.table.expire(now + least_answer_time - base::Duration(1));
  EXPECT_TRUE(rig.table.neighbours().is_known(former));
  rig.table.expire(now + least_answer_time);
  EXPECT_FALSE(rig.table.neighbours().is_known(former));
}

TEST_F(LastingSuccession, OfACopyOfADiskIsDenied) {
  (void)rig.hear(moved_life(7), now);
  (void)rig.table.report(now);
  rig.source = address;
  auto state = speaker(1, 1);
  state.lasting = 7;
  (void)rig.hear(state, now + milliseconds(50));
  rig.table.expire(now + seconds(3));
  EXPECT_TRUE(rig.table.neighbours().is_known(former));
}

TEST_F(LastingSuccession, IsNotOfAnotherIdentityOrOfNone) {
  for (const std::uint32_t lasting : {0U, 8U}) {
    (void)rig.hear(moved_life(lasting), now);
    EXPECT_THAT(rig.table.report(now).doubts, ::testing::IsEmpty());
  }
}

}  // namespace
}  // namespace geminga::membership
