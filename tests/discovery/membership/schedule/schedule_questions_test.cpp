// Presences that the schedule repeats while something is open: a lacked state, a doubt, a proof that is asked for.
#include <gmock/gmock.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "discovery/membership/schedule/deadline.hpp"
#include "discovery/membership/schedule/schedule.hpp"

namespace geminga::membership {
namespace {

using base::Instant;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Say = Schedule::Say;

constexpr Instant start{seconds(100)};

/// A schedule in its tenth second, when the copies of the first change are over.
Schedule running(std::uint64_t seed) {
  Schedule schedule({}, seed);
  schedule.changed(Say::state, start);
  while (schedule.due() <= start + seconds(10)) (void)schedule.take(schedule.due());
  return schedule;
}

TEST(Schedule, AsksAgainAndAgainForAsLongAsItHasAQuestionButEverMoreSlowly) {
  auto schedule = running(15);
  const auto begin = start + seconds(10);
  std::vector<base::Instant> asked;
  for (auto now = begin; now < begin + seconds(20); now += milliseconds(1)) {
    schedule.ask({.lacks = true}, now);
    if (schedule.due() <= now && schedule.take(now) == Say::presence) asked.push_back(now);
  }
  ASSERT_GT(asked.size(), 30U);
  EXPECT_LE(asked[0], begin + max_ask_delay);
  for (std::size_t i = 1; i < asked.size(); ++i) EXPECT_GE(asked[i] - asked[i - 1], lack_spacing) << i;
  EXPECT_LE(asked.size(), static_cast<std::size_t>(ask_capacity) + 10 * (1 + asks_per_interval) + 1);
  schedule.ask({}, begin + seconds(20));
  EXPECT_GE(schedule.due(), asked.back() + milliseconds(1800));
}

TEST(Schedule, LooksForWhoWasLostSoLongAfterEachWordUntilNobodyIsSoughtOrItsBudgetIsSpent) {
  const auto said_in = [](base::Duration time, bool is_sought) {
    auto schedule = running(31);
    const auto begin = start + seconds(10);
    std::vector<base::Instant> said;
    for (auto now = begin; now < begin + time; now += milliseconds(1)) {
      schedule.search(is_sought ? std::optional(milliseconds(500)) : std::nullopt, now);
      if (schedule.due() <= now && schedule.take(now) == Say::presence) said.push_back(now);
    }
    return said.size();
  };
  EXPECT_LE(said_in(seconds(20), false), 12U);
  EXPECT_GE(said_in(seconds(20), true), 36U);
  EXPECT_LE(said_in(seconds(20), true), 45U);
  const std::size_t others = 2 * 200 + 200 / search_refill_intervals;
  EXPECT_LE(said_in(seconds(400), true), static_cast<std::size_t>(search_capacity) + others);
}

TEST(Schedule, TellsAStrangerWhoLacksItsStateSoonAndOnTheBudgetForAnswers) {
  auto schedule = running(32);
  const auto begin = start + seconds(10);
  std::vector<base::Instant> said;
  for (auto now = begin; now < begin + seconds(20); now += milliseconds(1)) {
    schedule.lacked_by_stranger(now);
    if (schedule.due() <= now && schedule.take(now) == Say::state) said.push_back(now);
  }
  ASSERT_GE(said.size(), 10U);
  EXPECT_LE(said[0], begin + max_repair_delay);
  for (std::size_t i = 1; i < said.size(); ++i) EXPECT_GE(said[i] - said[i - 1], repair_spacing) << i;
  EXPECT_LE(said.size(), static_cast<std::size_t>(answer_capacity + 10 / answer_refill_intervals + 1));
  EXPECT_GE(schedule.due(), begin + seconds(20)) << "it does not say the state each time for a stranger's sake";
}

TEST(Schedule, SaysWhatSealingAsksOnABudgetOfItsOwn) {
  auto schedule = running(18);
  const auto begin = start + seconds(10);
  std::size_t said = 0;
  auto now = begin;
  for (; now < begin + seconds(20); now += milliseconds(1)) {
    schedule.challenge(true, now);
    if (schedule.due() <= now && schedule.take(now) == Say::presence) ++said;
  }
  EXPECT_GT(said, 30U);
  EXPECT_LE(said, static_cast<std::size_t>(ask_capacity) + 10 * (1 + asks_per_interval) + 1);
  schedule.ask({.lacks = true}, now);
  EXPECT_LE(schedule.due(), now + ask_spacing + max_ask_delay);
  schedule.ask({}, now);
  schedule.challenge(false, now);
  EXPECT_GT(schedule.due(), now + ask_spacing + max_ask_delay);
}

TEST(Schedule, DoubtsThoughWhatItMaySayOfTheLackedIsUsedUp) {
  auto schedule = running(17);
  auto now = start + seconds(10);
  for (const auto end = now + seconds(10); now < end; now += milliseconds(1)) {
    schedule.ask({.lacks = true}, now);
    if (schedule.due() <= now) (void)schedule.take(now);
  }
  schedule.ask({.lacks = true, .doubts = true}, now);
  EXPECT_LE(schedule.due(), now + ask_spacing + max_ask_delay);
  EXPECT_EQ(schedule.take(schedule.due()), Say::presence);
}

TEST(Schedule, GivesASignOfLifeAtOnceToWhoDoubtsItAndLetsADoubtedOneAnswerForItselfFirst) {
  auto schedule = running(16);
  const auto begin = start + seconds(10);
  schedule.doubted(begin);
  EXPECT_EQ(schedule.due(), begin);
  EXPECT_EQ(schedule.take(begin), Say::presence);
  EXPECT_TRUE(schedule.bear_witness(begin));
  EXPECT_GE(schedule.due(), begin + witness_delay);
  EXPECT_LE(schedule.due(), begin + 2 * witness_delay);
  EXPECT_FALSE(schedule.bear_witness(begin)) << "is due already";
  schedule.leave_testimony();
  EXPECT_GT(schedule.due(), begin + seconds(1)) << "it has answered for itself";
}

TEST(Schedule, DeniesItsNextLifeOftenInAShortWhileAndOnceInFiveIntervals) {
  auto schedule = running(16);
  const auto begin = start + seconds(10);
  const auto denied = [&](Instant from) {
    schedule.deny(from);
    std::size_t count = 0;
    while (schedule.due() < from + denials * denial_spacing)
      count += schedule.take(schedule.due()) == Say::presence ? 1 : 0;
    return count;
  };
  EXPECT_GE(denied(begin), std::size_t{denials});
  EXPECT_LE(denied(begin + seconds(3)), 1U);
  EXPECT_GE(denied(begin + seconds(10)), std::size_t{denials});
}

TEST(Schedule, SpeaksWhereSomebodyKnowsOthersButNotForEver) {
  auto schedule = running(17);
  const auto begin = start + seconds(10);
  std::vector<Instant> said;
  for (auto now = begin; now < begin + seconds(60); now += milliseconds(1)) {
    schedule.differ(now);
    if (schedule.due() <= now && schedule.take(now) == Say::presence) said.push_back(now);
  }
  EXPECT_GE(said[3], begin + 2 * differing_spacing);
  EXPECT_LE(said[3], begin + seconds(1));
  EXPECT_LE(said.size(), 34U + differing_capacity + 30);
}

}  // namespace
}  // namespace geminga::membership
