// Timelines of the schedule.
#include "beacon/schedule.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <vector>

namespace geminga::beacon {
namespace {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Instant start{seconds(100)};

/// All instants at which something is sent until `end`; `at` may change the schedule at its instants.
struct Disturbance {
  Instant when;
  std::function<void(Schedule&, Instant)> what;
};
std::vector<Instant> run(Schedule& schedule, Instant end, std::vector<Disturbance> disturbances = {}) {
  std::vector<Instant> sent;
  std::size_t next = 0;
  while (true) {
    const auto disturbed = next < disturbances.size() ? disturbances[next].when : base::never;
    const auto now = std::min(schedule.due(), disturbed);
    if (now > end) return sent;
    if (now == disturbed) disturbances[next].what(schedule, now), ++next;
    if (schedule.take(now)) sent.push_back(now);
    EXPECT_FALSE(schedule.take(now)) << "twice at one instant";
  }
}

Schedule running(std::uint64_t seed, Duration interval = seconds(2)) {
  Schedule schedule(ScheduleOptions{interval}, seed);
  schedule.changed(start);
  return schedule;
}

TEST(Schedule, SaysNothingBeforeItBegins) {
  Schedule schedule({}, 1);
  EXPECT_EQ(schedule.due(), base::never);
  schedule.newcomer(start);
  EXPECT_EQ(schedule.due(), base::never);
  EXPECT_FALSE(schedule.take(start));
}

TEST(Schedule, TellsAChangeAtOnceAndFourTimesAgain) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    auto schedule = running(seed);
    const auto sent = run(schedule, start + seconds(1));
    ASSERT_EQ(sent.size(), 5U) << "seed " << seed;
    EXPECT_EQ(sent[0], start);
    for (std::size_t i = 0; i < repeat_delays.size(); ++i) {
      const auto after = sent[i + 1] - start;
      EXPECT_GE(after, repeat_delays[i] * 8 / 10) << "seed " << seed;
      EXPECT_LE(after, repeat_delays[i] * 12 / 10) << "seed " << seed;
    }
  }
}

TEST(Schedule, RepeatsAnUnchangedStateEveryInterval) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    auto schedule = running(seed);
    run(schedule, start + seconds(1));
    auto last = start + seconds(1);
    const auto sent = run(schedule, start + seconds(2000));
    for (std::size_t i = 1; i < sent.size(); ++i) {
      EXPECT_GE(sent[i] - sent[i - 1], milliseconds(1800)) << "seed " << seed;
      EXPECT_LE(sent[i] - sent[i - 1], milliseconds(2200)) << "seed " << seed;
      last = sent[i];
    }
    EXPECT_GE(last, start + seconds(1997)) << "seed " << seed;
    EXPECT_NEAR(static_cast<double>(sent.size()), 1000, 15) << "seed " << seed;
  }
}

TEST(Schedule, DriftsApartForDifferentSeeds) {
  auto one = running(1);
  auto other = running(2);
  EXPECT_NE(run(one, start + seconds(60)), run(other, start + seconds(60)));
  auto same = running(1);
  auto again = running(1);
  EXPECT_EQ(run(same, start + seconds(60)), run(again, start + seconds(60)));
}

TEST(Schedule, TellsAChangeInQuietTimesWithoutAnyDelay) {
  auto schedule = running(3);
  const auto when = start + milliseconds(7654);
  const auto sent = run(schedule, when, {{when, [](Schedule& s, Instant now) { s.changed(now); }}});
  EXPECT_EQ(sent.back(), when);
}

TEST(Schedule, TellsChangesWithinTheSpacingTogether) {
  auto schedule = running(4);
  const auto when = start + seconds(5);
  const auto change = [](Schedule& s, Instant now) { s.changed(now); };
  run(schedule, when - milliseconds(1));
  // Both the last periodic one and this test's first one are more than the spacing away.
  const auto sent = run(schedule, when + min_spacing,
                        {{when, change}, {when + milliseconds(1), change}, {when + milliseconds(2), change}});
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_EQ(sent[0], when);
  EXPECT_EQ(sent[1], when + min_spacing);
}

TEST(Schedule, NeverSendsTwiceWithinTheSpacingNorMoreThanItsRate) {
  auto schedule = running(5);
  std::vector<Disturbance> changes;
  for (int i = 0; i < 10'000; ++i) {
    changes.push_back({start + milliseconds(i), [](Schedule& s, Instant now) { s.changed(now), s.newcomer(now); }});
  }
  const auto sent = run(schedule, start + seconds(10), std::move(changes));
  for (std::size_t i = 1; i < sent.size(); ++i) EXPECT_GE(sent[i] - sent[i - 1], min_spacing);
  EXPECT_LE(sent.size(), burst_capacity + seconds(10) / refill_time + 1);
  EXPECT_GE(sent.size(), static_cast<std::size_t>(seconds(10) / refill_time));
}

TEST(Schedule, AnswersANewcomerAfterAShortRandomTimeWithCopies) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    auto schedule = running(seed);
    // Right behind a periodic announcement, so that nothing else is due.
    run(schedule, start + seconds(10));
    const auto when = run(schedule, start + seconds(13)).back() + milliseconds(100);
    const auto sent =
        run(schedule, when + milliseconds(500), {{when, [](Schedule& s, Instant now) { s.newcomer(now); }}});
    ASSERT_EQ(sent.size(), 5U) << "seed " << seed;
    EXPECT_GE(sent[0], when);
    EXPECT_LE(sent[0], when + max_newcomer_delay);
  }
}

TEST(Schedule, AnswersNewcomersThatComeTogetherTogether) {
  auto schedule = running(6);
  run(schedule, start + seconds(10));
  const auto when = run(schedule, start + seconds(13)).back() + milliseconds(100);
  std::vector<Disturbance> newcomers;
  for (int i = 0; i < 30; ++i)
    newcomers.push_back({when + milliseconds(i), [](Schedule& s, Instant now) { s.newcomer(now); }});
  EXPECT_EQ(run(schedule, when + milliseconds(600), std::move(newcomers)).size(), 5U);
}

TEST(Schedule, DoesNotLetForgedNewcomersMakeItASourceOfTraffic) {
  auto schedule = running(7);
  std::vector<Disturbance> newcomers;
  for (int i = 0; i < 100'000; ++i)
    newcomers.push_back({start + milliseconds(i), [](Schedule& s, Instant now) { s.newcomer(now); }});
  const auto sent = run(schedule, start + seconds(100), std::move(newcomers));
  EXPECT_LE(sent.size(), 5U * 100 + 10);
}

TEST(Schedule, AnswersANewcomerThatCopiesDoNotReachWhenTheSpacingIsOver) {
  auto schedule = running(8);
  run(schedule, start + seconds(10));
  const auto first = run(schedule, start + seconds(13)).back() + milliseconds(100);
  const auto newcomer = [](Schedule& s, Instant now) { s.newcomer(now); };
  const auto sent =
      run(schedule, first + milliseconds(1600), {{first, newcomer}, {first + milliseconds(500), newcomer}});
  ASSERT_EQ(sent.size(), 10U);
  EXPECT_EQ(sent[5], sent[0] + newcomer_spacing);
}

TEST(Schedule, AnswersEachClaimToItsIdentifierAtOnceWithOneCopy) {
  auto schedule = running(12);
  run(schedule, start + seconds(10));
  const auto when = run(schedule, start + seconds(13)).back() + milliseconds(100);
  const auto contested = [](Schedule& s, Instant now) { s.contested(now); };
  const std::vector<Instant> claims{when, when + milliseconds(30), when + milliseconds(60)};
  const auto sent =
      run(schedule, when + milliseconds(500), {{claims[0], contested}, {claims[1], contested}, {claims[2], contested}});
  EXPECT_EQ(sent, claims);
  schedule.pause();
  schedule.contested(when + seconds(1));
  EXPECT_EQ(schedule.due(), base::never);
}

TEST(Schedule, IsSilentWhilePaused) {
  auto schedule = running(9);
  run(schedule, start + milliseconds(30));
  schedule.pause();
  schedule.newcomer(start + milliseconds(40));
  EXPECT_EQ(schedule.due(), base::never);
  schedule.changed(start + milliseconds(50));
  EXPECT_EQ(schedule.due(), start + milliseconds(50));
}

TEST(Schedule, SaysGoodbyeAtOnceAndTwiceAgainAndThenNothing) {
  auto schedule = running(10);
  const auto end = start + seconds(5);
  run(schedule, end);
  schedule.stop(end);
  EXPECT_FALSE(schedule.is_finished());
  schedule.changed(end);
  schedule.newcomer(end);
  const auto sent = run(schedule, end + seconds(10));
  EXPECT_THAT(sent, ::testing::ElementsAre(end, end + goodbye_spacing, end + 2 * goodbye_spacing));
  EXPECT_TRUE(schedule.is_finished());
  EXPECT_EQ(schedule.due(), base::never);
}

TEST(Schedule, IsNotHarmedByATimerThatComesLate) {
  auto schedule = running(11);
  ASSERT_TRUE(schedule.take(start + seconds(1)));
  EXPECT_FALSE(schedule.take(start + seconds(1)));
  EXPECT_GE(schedule.due(), start + milliseconds(2800));
}

}  // namespace
}  // namespace geminga::beacon
