#include "discovery/participant/air/diagnoses.hpp"

#include <gtest/gtest.h>

namespace geminga::participant {
namespace {

using std::chrono::seconds;

constexpr base::Instant midnight{seconds(1000)};
constexpr ParticipantId robot{7};

announcement::Announcement answer(std::uint64_t token, ParticipantId from = robot) {
  announcement::Announcement diagnosis;
  diagnosis.kind = announcement::Kind::diagnosis;
  diagnosis.participant = from;
  diagnosis.token = token;
  diagnosis.lines = {"status version=1.0.0"};
  return diagnosis;
}

TEST(Diagnoses, AreAskedForAgainWithTheSameTokenUntilTheyCome) {
  Diagnoses diagnoses;
  EXPECT_EQ(diagnoses.ask(robot, 11, midnight), 11U);
  EXPECT_EQ(diagnoses.ask(robot, 12, midnight + inquiry_spacing - base::Duration(1)), std::nullopt);
  EXPECT_EQ(diagnoses.ask(robot, 13, midnight + inquiry_spacing), 11U);
  diagnoses.hear_diagnosis(answer(11), midnight + seconds(1));
  ASSERT_NE(diagnoses.answer_of(robot, midnight + seconds(1)), nullptr);
  EXPECT_EQ(diagnoses.ask(robot, 14, midnight + seconds(1) + diagnosis_life), std::nullopt);
  EXPECT_EQ(diagnoses.ask(robot, 15, midnight + seconds(1) + diagnosis_life + base::Duration(1)), 15U)
      << "it is too old";
  EXPECT_EQ(diagnoses.answer_of(robot, midnight + seconds(7)), nullptr);
}

TEST(Diagnoses, AreDroppedUnlessTheyWereAskedFor) {
  Diagnoses diagnoses;
  diagnoses.hear_diagnosis(answer(11), midnight);
  EXPECT_EQ(diagnoses.answer_of(robot, midnight), nullptr);
  ASSERT_TRUE(diagnoses.ask(robot, 11, midnight));
  diagnoses.hear_diagnosis(answer(12), midnight);
  diagnoses.hear_diagnosis(answer(11, ParticipantId{8}), midnight);
  EXPECT_EQ(diagnoses.answer_of(robot, midnight), nullptr);
  diagnoses.hear_diagnosis(answer(11), midnight + inquiry_patience + base::Duration(1));
  EXPECT_EQ(diagnoses.answer_of(robot, midnight), nullptr) << "nobody waits for it any more";
}

TEST(Diagnoses, AreAskedForEightTimesAtOnceAndThenOnceASecond) {
  Diagnoses diagnoses;
  std::size_t asked = 0;
  for (std::uint32_t number = 1; number <= 20; ++number)
    asked += diagnoses.ask(ParticipantId{number}, 1, midnight) ? 1 : 0;
  EXPECT_EQ(asked, static_cast<std::size_t>(inquiry_capacity));
  EXPECT_TRUE(diagnoses.ask(ParticipantId{21}, 1, midnight + exchange_refill));
  EXPECT_FALSE(diagnoses.ask(ParticipantId{22}, 1, midnight + exchange_refill));
}

TEST(Diagnoses, AreGivenFourTimesAtOnceAndThenOnceASecond) {
  Diagnoses diagnoses;
  std::size_t given = 0;
  for (int i = 0; i < 100; ++i) given += diagnoses.may_answer(midnight) ? 1 : 0;
  EXPECT_EQ(given, static_cast<std::size_t>(diagnosis_capacity));
  EXPECT_TRUE(diagnoses.may_answer(midnight + exchange_refill));
  EXPECT_FALSE(diagnoses.may_answer(midnight + exchange_refill));
}

TEST(Diagnoses, OfEightParticipantsAreRemembered) {
  Diagnoses diagnoses;
  base::Instant now = midnight;
  for (std::uint32_t number = 1; number <= max_diagnoses + 1; ++number, now += exchange_refill) {
    ASSERT_TRUE(diagnoses.ask(ParticipantId{number}, number, now));
    diagnoses.hear_diagnosis(answer(number, ParticipantId{number}), midnight + seconds(8));
  }
  EXPECT_EQ(diagnoses.answer_of(ParticipantId{1}, midnight + seconds(8)), nullptr) << "the oldest gave way";
  EXPECT_NE(diagnoses.answer_of(ParticipantId{2}, midnight + seconds(8)), nullptr);
}

}  // namespace
}  // namespace geminga::participant
