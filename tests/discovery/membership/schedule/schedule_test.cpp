// Timelines of the schedule.
#include "discovery/membership/schedule/schedule.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace geminga::membership {
namespace {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Say = Schedule::Say;

constexpr Instant start{seconds(100)};

/// All instants at which something is sent, or only `what`, until `end`.
struct Disturbance {
  Instant when;
  std::function<void(Schedule&, Instant)> what;
};
std::vector<Instant> run(Schedule& schedule, Instant end, std::vector<Disturbance> disturbances = {},
                         std::optional<Say> what = {}) {
  std::vector<Instant> sent;
  std::size_t next = 0;
  while (true) {
    const auto disturbed = next < disturbances.size() ? disturbances[next].when : base::never;
    const auto now = std::min(schedule.due(), disturbed);
    if (now > end) return sent;
    if (now == disturbed) disturbances[next].what(schedule, now), ++next;
    if (const auto said = schedule.take(now); said != Say::nothing && said == what.value_or(said)) sent.push_back(now);
    EXPECT_EQ(schedule.take(now), Say::nothing) << "twice at one instant";
  }
}

Schedule running(std::uint64_t seed, Duration interval = seconds(2)) {
  Schedule schedule(ScheduleOptions{interval}, seed);
  schedule.changed(Say::state, start);
  return schedule;
}

TEST(Schedule, SaysNothingBeforeItBegins) {
  Schedule schedule({}, 1);
  EXPECT_EQ(schedule.due(), base::never);
  schedule.newcomer(start);
  EXPECT_EQ(schedule.due(), base::never);
  EXPECT_EQ(schedule.take(start), Say::nothing);
}

TEST(Schedule, TellsAChangeAtOnceAndAgainAsOftenAsTheLossAsksFor) {
  for (const auto& [loss, states] :
       std::map<std::optional<double>, std::size_t>{{std::nullopt, 4}, {0.0, 1}, {0.01, 2}, {0.1, 3}, {0.3, 5}}) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      Schedule schedule({}, seed);
      schedule.set_loss(loss);
      schedule.changed(Say::state, start);
      std::vector<std::pair<base::Instant, Say>> sent;
      while (schedule.due() < start + seconds(1)) {
        const auto now = schedule.due();
        sent.emplace_back(now, schedule.take(now));
      }
      ASSERT_EQ(sent.size(), states + (loss ? std::min(states, presence_copies) : unknown_presence_copies))
          << "seed " << seed;
      EXPECT_EQ(sent[0].first, start);
      for (std::size_t i = 0; i < sent.size(); ++i) {
        EXPECT_EQ(sent[i].second, i < states ? Say::state : Say::presence) << "seed " << seed;
        if (i == 0) continue;
        const auto after = sent[i].first - start;
        EXPECT_GE(after, repeat_delays[i - 1] * 8 / 10) << "seed " << seed;
        EXPECT_LE(after, repeat_delays[i - 1] * 12 / 10) << "seed " << seed;
      }
    }
  }
}

TEST(Schedule, ShowsItselfMoreOftenBehindAChangeWhereMuchIsLost) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Schedule schedule({}, seed);
    schedule.set_loss(bad_loss);
    schedule.changed(Say::state, start);
    std::map<Say, std::size_t> sent;
    while (schedule.due() < start + milliseconds(1100)) ++sent[schedule.take(schedule.due())];
    EXPECT_EQ(sent[Say::state], state_copies(bad_loss)) << "seed " << seed;
    EXPECT_LE(sent[Say::presence], presence_copies + bad_presence_delays.size()) << "seed " << seed;
    EXPECT_GE(sent[Say::presence], presence_copies + bad_presence_delays.size() - 1)
        << "two may be due at once; seed " << seed;
  }
}

TEST(Schedule, SaysInEachIntervalThatAnUnchangedStateIsAsItWas) {
  auto schedule = running(12);
  run(schedule, start + seconds(1));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(schedule.take(schedule.due()), Say::presence);
}

TEST(Schedule, SaysItsStateAgainToWhoLacksItAndForFiveIntervalsToWhoGoesOnAsking) {
  auto schedule = running(13);
  const auto asked = start + seconds(10);
  run(schedule, asked);
  for (int i = 0; i < 9; ++i) schedule.lacked(asked);
  EXPECT_LE(schedule.due(), asked + max_repair_delay);
  EXPECT_EQ(schedule.take(schedule.due()), Say::state);
  EXPECT_GE(schedule.due(), asked + seconds(1)) << "one repeat answers all who ask";
  schedule.lacked(asked + milliseconds(999));
  EXPECT_EQ(schedule.take(schedule.due()), Say::state);
  EXPECT_EQ(schedule.take(schedule.due()), Say::presence) << "not for so long";
  const auto again = asked + seconds(4);
  run(schedule, again);
  schedule.lacked(again);
  schedule.lacked(again + seconds(1));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(schedule.take(schedule.due()), Say::state);
  run(schedule, again + seconds(14));
  EXPECT_EQ(schedule.take(schedule.due()), Say::presence);
}

TEST(Schedule, RepeatsItsStateForThoseWhoLackItABoundedNumberOfTimes) {
  auto schedule = running(14);
  std::size_t states = 0;
  const auto begin = start + seconds(10);
  run(schedule, begin);
  for (auto now = begin; now < begin + seconds(100); now += milliseconds(1)) {
    schedule.lacked(now);
    if (schedule.due() <= now && schedule.take(now) == Say::state) ++states;
  }
  EXPECT_LE(states, static_cast<std::size_t>(repair_capacity) + 50 * (1 + repairs_per_interval) + 2);
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
  const auto sent = run(schedule, when, {{when, [](Schedule& s, Instant now) { s.changed(Say::state, now); }}});
  EXPECT_EQ(sent.back(), when);
}

TEST(Schedule, TellsChangesWithinTheSpacingTogether) {
  auto schedule = running(4);
  const auto when = start + seconds(5);
  const auto change = [](Schedule& s, Instant now) { s.changed(Say::state, now); };
  run(schedule, when - milliseconds(1));
  // Both the last periodic announcement and this test's first one are more than the spacing away.
  const auto sent = run(schedule, when + change_spacing,
                        {{when, change}, {when + milliseconds(1), change}, {when + milliseconds(19), change}});
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_EQ(sent[0], when);
  EXPECT_EQ(sent[1], when + change_spacing);
}

TEST(Schedule, TellsChangesThatGoOnEverMoreSeldomUpToTheLongestSpacing) {
  auto schedule = running(4);
  const auto when = start + seconds(5);
  schedule.set_loss(0);
  run(schedule, when - milliseconds(1));
  std::vector<Disturbance> changes;
  for (int i = 0; i <= 500; ++i) {
    changes.push_back({when + milliseconds(i), [](Schedule& s, Instant now) { s.changed(Say::state, now); }});
  }
  const auto sent = run(schedule, when + milliseconds(500), std::move(changes));
  EXPECT_THAT(sent, testing::ElementsAre(when, when + milliseconds(20), when + milliseconds(60),
                                         when + milliseconds(140), when + milliseconds(300), when + milliseconds(460)));
}

TEST(Schedule, ShowsItselfLaterOnAsWellWhereManyShareTheAir) {
  auto schedule = running(9);
  schedule.set_doublings(3, start);
  run(schedule, start + seconds(100));
  const auto when = run(schedule, start + seconds(140)).back() + seconds(1);
  schedule.set_loss(0);
  const auto sent =
      run(schedule, when + seconds(5), {{when, [](Schedule& s, Instant now) { s.changed(Say::change, now); }}});
  ASSERT_EQ(sent.size(), 5U) << "the change, the presence behind it, and three more";
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GE(sent[2 + i] - when, late_presence_delays[i] * 8 / 10);
}

TEST(Schedule, NeverSendsTwiceWithinTheSpacingNorMoreThanItsRate) {
  auto schedule = running(5);
  std::vector<Disturbance> changes;
  for (int i = 0; i < 10'000; ++i) {
    changes.push_back(
        {start + milliseconds(i), [](Schedule& s, Instant now) { s.changed(Say::state, now), s.newcomer(now); }});
  }
  const auto sent = run(schedule, start + seconds(10), std::move(changes));
  for (std::size_t i = 1; i < sent.size(); ++i) EXPECT_GE(sent[i] - sent[i - 1], min_spacing);
  EXPECT_LE(sent.size(), burst_capacity + seconds(10) / refill_time + 1);
  EXPECT_GE(sent.size(), static_cast<std::size_t>(seconds(10) / longest_change_spacing));
}

/// While the loss is not known.
constexpr std::size_t all_answers = 1 + answer_delays.size() + answer_presence_delays.size();

TEST(Schedule, AnswersANewcomerAfterAShortRandomTimeWithCopies) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    auto schedule = running(seed);
    // This is right behind a periodic announcement, so that nothing else is due.
    run(schedule, start + seconds(10));
    const auto when = run(schedule, start + seconds(13)).back() + milliseconds(100);
    const auto sent =
        run(schedule, when + milliseconds(600), {{when, [](Schedule& s, Instant now) { s.newcomer(now); }}});
    ASSERT_EQ(sent.size(), all_answers) << "seed " << seed;
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
  EXPECT_EQ(run(schedule, when + milliseconds(600), std::move(newcomers)).size(), all_answers);
}

/// The datagrams on one link in a minute with one newcomer a second, beyond those without newcomers.
std::int64_t cost_of_newcomers(std::size_t size) {
  const auto count = [size](bool has_newcomers) {
    auto schedule = running(7);
    schedule.set_size(size);
    run(schedule, start + seconds(10));
    std::vector<Disturbance> newcomers;
    for (int i = 10; has_newcomers && i < 70; ++i)
      newcomers.push_back({start + seconds(i), [](Schedule& s, Instant now) { s.newcomer(now); }});
    return static_cast<std::int64_t>(run(schedule, start + seconds(70), std::move(newcomers), Say::state).size() *
                                     size);
  };
  return count(true) - count(false);
}

TEST(Schedule, DoesNotLetForgedNewcomersMakeItASourceOfTraffic) {
  const auto refilled = seconds(60) / (answer_refill_intervals * seconds(2));
  EXPECT_LE(cost_of_newcomers(1), answer_capacity + refilled + 1);
  EXPECT_LE(cost_of_newcomers(8), answer_capacity + refilled + 2 * 8);
  EXPECT_LE(cost_of_newcomers(300), 300) << "a large state is told once";
}

TEST(Schedule, AnswersNewcomersInTheLongRunForAQuarterOfWhatItsPeriodicAnnouncementsCost) {
  auto schedule = running(7);
  const auto minutes = std::chrono::minutes(60);
  std::vector<Disturbance> newcomers;
  for (auto now = start; now < start + minutes; now += milliseconds(100))
    newcomers.push_back({now, [](Schedule& s, Instant at) { s.newcomer(at); }});
  const auto sent = run(schedule, start + minutes, std::move(newcomers));
  EXPECT_LE(sent.size(), static_cast<std::size_t>(minutes / seconds(2) * 5 / 4) + 60);
}

TEST(Schedule, AnswersTenNewcomersThatComeOneBehindTheOtherAndAnswersAgainWhenTheBudgetIsBack) {
  auto schedule = running(7);
  run(schedule, start + seconds(10));
  auto now = start + seconds(10);
  const auto is_answered = [&] {
    now += 2 * newcomer_spacing;
    run(schedule, now);
    const auto sent = run(schedule, now + max_newcomer_delay, {{now, [](Schedule& s, Instant at) { s.newcomer(at); }}});
    return !sent.empty();
  };
  std::size_t answered = 0;
  for (std::size_t i = 0; i < 10; ++i) answered += is_answered() ? 1 : 0;
  EXPECT_EQ(answered, 10U);
  now += answer_capacity * answer_refill_intervals * seconds(2);
  run(schedule, now);
  EXPECT_TRUE(is_answered());
}

TEST(Schedule, AnswersANewcomerThatCopiesDoNotReachWhenTheSpacingIsOver) {
  auto schedule = running(8);
  run(schedule, start + seconds(10));
  const auto first = run(schedule, start + seconds(13)).back() + milliseconds(100);
  const auto newcomer = [](Schedule& s, Instant now) { s.newcomer(now); };
  const auto sent =
      run(schedule, first + milliseconds(1600), {{first, newcomer}, {first + milliseconds(500), newcomer}});
  ASSERT_EQ(sent.size(), 2 * all_answers);
  EXPECT_EQ(sent[all_answers], sent[0] + newcomer_spacing);
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

TEST(Schedule, AnswersAClaimBeforeItsNinetyMillisecondsAreOverEvenWhileAForgerClaimsWithoutEnd) {
  auto schedule = running(12);
  run(schedule, start + seconds(1));
  std::vector<Disturbance> claims;
  for (int i = 1000; i < 11'000; ++i)
    claims.push_back({start + milliseconds(i), [](Schedule& s, Instant now) { s.contested(now); }});
  const auto sent = run(schedule, start + seconds(11), std::move(claims));
  for (std::size_t i = 1; i < sent.size(); ++i) EXPECT_LT(sent[i] - sent[i - 1], milliseconds(90));
  EXPECT_LE(sent.size(), static_cast<std::size_t>(contest_capacity + seconds(10) / contest_refill) + 6);
}

TEST(Schedule, ShowsItsPresenceOnlyWhereItIsContestedAndItsStateIsNotDueAnyway) {
  auto schedule = running(12);
  schedule.contested(start);
  EXPECT_EQ(schedule.take(start), Say::state);
  run(schedule, start + seconds(1));
  schedule.contested(start + seconds(1));
  EXPECT_EQ(schedule.take(start + seconds(1)), Say::presence);
}

TEST(Schedule, DoesNotDelayAChangeWhileItIsContested) {
  auto schedule = running(12);
  std::vector<Disturbance> disturbances;
  for (int i = 1000; i < 3000; ++i)
    disturbances.push_back({start + milliseconds(i), [](Schedule& s, Instant now) { s.contested(now); }});
  run(schedule, start + seconds(2), disturbances);
  const auto when = start + seconds(2);
  schedule.changed(Say::state, when);
  ASSERT_LE(schedule.due(), when + min_spacing);
  EXPECT_EQ(schedule.take(schedule.due()), Say::state);
}

TEST(Schedule, ContradictsALieAtOnceAndABoundedNumberOfTimes) {
  auto schedule = running(13);
  run(schedule, start + seconds(10));
  const auto when = run(schedule, start + seconds(13)).back() + milliseconds(100);
  const auto contradict = [](Schedule& s, Instant now) { s.contradict(now); };
  EXPECT_EQ(run(schedule, when + milliseconds(1), {{when, contradict}}), std::vector{when});
  std::vector<Disturbance> lies;
  for (int i = 2; i < 60'000; ++i) lies.push_back({when + milliseconds(i), contradict});
  const auto sent = run(schedule, when + seconds(60), std::move(lies));
  EXPECT_LE(sent.size(), static_cast<std::size_t>(contradiction_capacity + 30 * contradictions_per_interval));
  EXPECT_GE(sent.size(), static_cast<std::size_t>(30 * contradictions_per_interval));
}

TEST(Schedule, IsSilentWhilePaused) {
  auto schedule = running(9);
  run(schedule, start + milliseconds(30));
  schedule.pause();
  schedule.newcomer(start + milliseconds(40));
  EXPECT_EQ(schedule.due(), base::never);
  schedule.changed(Say::state, start + milliseconds(50));
  EXPECT_EQ(schedule.due(), start + milliseconds(50));
}

TEST(Schedule, SaysGoodbyeAtOnceAndTwiceAgainAndThenNothing) {
  auto schedule = running(10);
  const auto end = start + seconds(5);
  run(schedule, end);
  schedule.stop(end);
  EXPECT_FALSE(schedule.is_finished());
  schedule.changed(Say::state, end);
  schedule.newcomer(end);
  const auto sent = run(schedule, end + seconds(10));
  EXPECT_THAT(sent, ::testing::ElementsAre(end, end + goodbye_spacing, end + 2 * goodbye_spacing));
  EXPECT_TRUE(schedule.is_finished());
  EXPECT_EQ(schedule.due(), base::never);
}

TEST(Schedule, IsNotHarmedByATimerThatComesLate) {
  auto schedule = running(11);
  ASSERT_EQ(schedule.take(start + seconds(1)), Say::state);
  ASSERT_EQ(schedule.take(start + milliseconds(1003)), Say::presence);
  EXPECT_EQ(schedule.take(start + milliseconds(1003)), Say::nothing);
  EXPECT_GE(schedule.due(), start + milliseconds(2800));
}

}  // namespace
}  // namespace geminga::membership
