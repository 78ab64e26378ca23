// Living robots are not lost however bad the air is, dead ones are noticed soon, and both cost few octets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/robots.hpp"
#include "support/rounds.hpp"

namespace geminga::sim {
namespace {
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

constexpr Bounds patient = {.missing = seconds(30), .surplus = seconds(30)};

/// False departures of a team in some minutes.
std::set<std::string> departures(int robots, double loss, std::chrono::minutes time, std::uint64_t seed) {
  Robots team(World::seed_or(seed), robots, {.loss = loss, .longest_delay = milliseconds(5)}, patient);
  team.start();
  EXPECT_TRUE(team.team.settle(seconds(30)));
  team.world.run_for(time);
  EXPECT_TRUE(team.team.is_right()) << team.world.when() << "\n" << team.team.complaints();
  return team.team.false_departures();
}

TEST(Loss, OfThirtyPercentLosesNoneOfTenLivingRobots) {
  EXPECT_THAT(departures(10, 0.3, minutes(20), 21), testing::IsEmpty());
}

TEST(Loss, OfFiftyPercentLosesNoneOfTenLivingRobots) {
  EXPECT_THAT(departures(10, 0.5, minutes(20), 22), testing::IsEmpty());
}

TEST(Loss, OfThirtyPercentLosesNoneOfThirtyLivingRobots) {
  EXPECT_THAT(departures(30, 0.3, minutes(2), 23), testing::IsEmpty());
}

TEST(Loss, LosesNeitherOfTwoLivingRobotsThatNobodyElseHears) {
  EXPECT_THAT(departures(2, 0.3, minutes(60), 24), testing::IsEmpty());
  EXPECT_THAT(departures(2, 0.5, minutes(60), 25), testing::IsEmpty());
}

/// Until what everybody was told is right.
base::Duration until_right(Robots& robots) {
  const auto begin = robots.world.now();
  while (!robots.team.is_right() && robots.world.now() - begin < seconds(60)) robots.world.run_for(milliseconds(5));
  return robots.world.now() - begin;
}

/// How long it takes until all others know that one of ten was killed.
base::Duration told_of_death(double loss, std::uint64_t seed) {
  Robots robots(World::seed_or(seed), 10, {.loss = loss, .longest_delay = milliseconds(5)}, patient);
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(30)));
  robots.world.run_for(minutes(2));
  robots.host(4).crash();
  return until_right(robots);
}

TEST(Loss, HidesADeathForThreeIntervalsAtMost) {
  EXPECT_LE(told_of_death(0, 26), milliseconds(4'600));
  EXPECT_LE(told_of_death(0.1, 27), milliseconds(4'800));
  EXPECT_LE(told_of_death(0.3, 28), milliseconds(5'500));
  EXPECT_LE(told_of_death(0.5, 29), milliseconds(6'800));
}

/// How long views are wrong after a daemon was killed and started again.
base::Duration restarted(double loss, base::Duration after, std::uint64_t seed) {
  Robots robots(World::seed_or(seed), 10, {.loss = loss, .longest_delay = milliseconds(5)}, patient);
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(30)));
  robots.world.run_for(after);
  robots.host(4).crash();
  robots.world.run_for(milliseconds(30));
  robots.host(4).switch_on();
  return until_right(robots);
}

TEST(Loss, ARestartedDaemonTakesThePlaceOfItsFormerLife) {
  for (const base::Duration after : {base::Duration(seconds(3)), base::Duration(minutes(2))}) {
    EXPECT_LE(restarted(0, after, 40), milliseconds(200));
    EXPECT_LE(restarted(0.1, after, 41), milliseconds(400));
    EXPECT_LE(restarted(0.3, after, 42), seconds(1));
    EXPECT_LE(restarted(0.5, after, 43), seconds(2));
  }
}

/// How long it takes until all of ten are told of all, who are switched on at the same instant.
base::Duration begun(double loss, std::uint64_t seed) {
  Robots robots(World::seed_or(seed), 10, {.loss = loss, .longest_delay = milliseconds(5)}, patient);
  for (const auto& host : robots.world.hosts()) host->switch_on();
  for (const auto& module : robots.team.modules()) module->run();
  return until_right(robots);
}

/// Of twenty times the middle one is at most `usual`, and the worst but one at most `bad`. Of fewer rounds, three at
/// least.
void expect_soon(base::Duration (*measure)(double, std::uint64_t), double loss, base::Duration usual,
                 base::Duration bad) {
  std::vector<base::Duration> times;
  const std::size_t count = std::max(3U, test::rounds(20U));
  for (std::uint64_t seed = 60; seed < 60 + count; ++seed) times.push_back(measure(loss, seed));
  std::ranges::sort(times);
  EXPECT_LE(times[count / 2], usual) << "at a loss of " << loss;
  EXPECT_LE(times[count - 2], bad) << "at a loss of " << loss;
}

TEST(Loss, LetsATeamThatIsSwitchedOnKnowEachOtherSoon) {
  expect_soon(begun, 0, milliseconds(100), milliseconds(150));
  expect_soon(begun, 0.1, milliseconds(150), milliseconds(200));
  expect_soon(begun, 0.3, milliseconds(200), milliseconds(400));
  expect_soon(begun, 0.5, milliseconds(600), milliseconds(1500));
}

base::Duration restarted_after_a_minute(double loss, std::uint64_t seed) { return restarted(loss, minutes(1), seed); }

TEST(Loss, LetsARestartedDaemonTakeItsPlaceSoon) {
  expect_soon(restarted_after_a_minute, 0, milliseconds(100), milliseconds(100));
  expect_soon(restarted_after_a_minute, 0.1, milliseconds(100), milliseconds(250));
  expect_soon(restarted_after_a_minute, 0.3, milliseconds(250), milliseconds(500));
  expect_soon(restarted_after_a_minute, 0.5, milliseconds(450), seconds(1));
}

/// How long views are wrong after two halves of a team, in each of which something has changed, meet again.
base::Duration rejoined(double loss, std::uint64_t seed) {
  Robots robots(World::seed_or(seed), 10, {.loss = loss, .longest_delay = milliseconds(5)}, patient);
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(30)));
  robots.world.run_for(seconds(10));
  const auto move = [&robots](int island) {
    for (std::size_t i = 0; i < 5; ++i) robots.host(i).set_island(island);
  };
  move(1);
  robots.world.run_for(seconds(15));
  for (const std::size_t module : {0U, 20U}) robots.module(module).offer("ball", stream);
  robots.world.run_for(seconds(15));
  move(0);
  return until_right(robots);
}

// One test for each loss, so that none is long under a sanitizer.
TEST(Loss, OfNothingHealsAPartitionSoon) { expect_soon(rejoined, 0, milliseconds(100), milliseconds(250)); }
TEST(Loss, OfTenPercentHealsAPartitionSoon) { expect_soon(rejoined, 0.1, milliseconds(170), milliseconds(330)); }
TEST(Loss, OfThirtyPercentHealsAPartitionSoon) { expect_soon(rejoined, 0.3, milliseconds(330), milliseconds(700)); }
TEST(Loss, OfFiftyPercentHealsAPartitionSoon) { expect_soon(rejoined, 0.5, milliseconds(690), milliseconds(1500)); }

/// How long it takes from the first word of somebody who has not heard a change for two intervals until the one who
/// made it speaks.
base::Duration repeated_for_who_missed_it(std::uint64_t seed) {
  Robots robots(World::seed_or(seed), 4, {}, patient);
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(30)));
  robots.world.run_for(minutes(1));
  const Host& changes = robots.host(0);
  const Host& misses = robots.host(1);
  robots.world.cut(changes, misses);
  robots.module(0).offer("late", stream);
  robots.world.run_for(seconds(4));
  base::Instant asked = base::never;
  base::Instant repeated = base::never;
  robots.world.on_transmit = [&](const Host& sender, std::string_view) {
    if (&sender == &misses) asked = std::min(asked, robots.world.now());
    if (&sender == &changes && asked != base::never) repeated = std::min(repeated, robots.world.now());
  };
  robots.world.run_for(seconds(10));
  return repeated - asked;
}

TEST(Loss, OfAllThatOneHostSaysOfAChangeIsFoundOutByWhatItSaysOfWhomItHears) {
  for (std::uint64_t seed = 60; seed < 65; ++seed) EXPECT_LE(repeated_for_who_missed_it(seed), milliseconds(200));
}

/// Octets a second that one of so many hosts sends while nothing changes, with 42 octets of headers for each frame.
double steady_traffic(int count, double loss, std::uint64_t seed) {
  Robots robots(World::seed_or(seed), count, {.loss = loss, .longest_delay = milliseconds(5)}, patient);
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(30)));
  robots.world.run_for(seconds(20));
  const auto octets = robots.world.datagram_bytes() + 42 * robots.world.datagrams();
  robots.world.run_for(minutes(1));
  const auto sent = robots.world.datagram_bytes() + 42 * robots.world.datagrams() - octets;
  return static_cast<double>(sent) / 60 / count;
}

TEST(Loss, CostsFewOctets) {
  const auto is_within = [](double octets, double most) {
    EXPECT_LE(octets, most);
    EXPECT_GT(octets, 20) << "who is silent is not heard";
  };
  is_within(steady_traffic(10, 0, 30), 45);
  is_within(steady_traffic(10, 0.1, 31), 45);
  is_within(steady_traffic(10, 0.3, 32), 60);
  is_within(steady_traffic(10, 0.5, 33), 90);
  is_within(steady_traffic(30, 0.3, 34), 70);
}

TEST(OneWay, WhoseMulticastsAreFilteredIsToldSo) {
  Robots robots(World::seed_or(71), 4, {});
  robots.team.is_excused = true;
  robots.start();
  robots.world.run_for(seconds(10));
  for (std::size_t i = 1; i < 4; ++i) robots.world.cut(robots.host(0), robots.host(i));
  const auto ask = [&](Host& host, const std::string& query) {
    Client& client = robots.world.add_client("asker");
    client.connect(host);
    client.say("1 query " + query);
    robots.world.run_for(milliseconds(1));
    client.hang_up();
    return client.lines;
  };
  const auto deaf = [&](Host& host) {
    return std::ranges::count_if(ask(host, "participants"),
                                 [](const std::string& line) { return line.contains(" hears_us=0"); });
  };
  EXPECT_EQ(deaf(robots.host(0)), 0);
  robots.world.run_for(seconds(45));
  EXPECT_EQ(deaf(robots.host(0)), 3) << "they do not even know it any more";
  EXPECT_THAT(ask(robots.host(0), "status"), testing::Contains(testing::HasSubstr(" unheard_by=3 ")));
  const auto logged = [&](Host& host, const std::string& words) {
    return std::ranges::count_if(host.logged, [&](const std::string& line) { return line.contains(words); });
  };
  EXPECT_EQ(logged(robots.host(0), "does not hear us"), 3) << "each once";
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(logged(robots.host(i), "does not hear us"), 0);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(deaf(robots.host(i)), 0);
  for (std::size_t i = 1; i < 4; ++i) robots.world.mend(robots.host(0), robots.host(i));
  robots.world.run_for(seconds(10));
  EXPECT_EQ(deaf(robots.host(0)), 0);
  EXPECT_EQ(logged(robots.host(0), "does not hear us"), 3);
  EXPECT_EQ(logged(robots.host(0), "hears us again"), 3);
}

/// The same when it comes back with another name and a folder in which it kept who it is.
base::Duration renamed(double loss, std::uint64_t seed) {
  Robots robots(World::seed_or(seed), 10, {.loss = loss, .longest_delay = milliseconds(5)}, patient);
  robots.host(4).settings.lasting = 77;
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(30)));
  robots.world.run_for(minutes(1));
  robots.host(4).crash();
  robots.world.run_for(milliseconds(30));
  robots.host(4).settings.name = "renamed";
  robots.host(4).switch_on();
  return until_right(robots);
}

TEST(Loss, ARenamedDaemonTakesThePlaceOfItsFormerLifeWhereItsIdentityLasts) {
  EXPECT_LE(renamed(0, 44), milliseconds(200));
  EXPECT_LE(renamed(0.1, 45), milliseconds(400));
  EXPECT_LE(renamed(0.3, 46), seconds(1));
}

TEST(Loss, CopiesOfADiskLiveBesideEachOther) {
  for (const double loss : {0.0, 0.3}) {
    Robots robots(World::seed_or(47), 6, {.loss = loss, .longest_delay = milliseconds(5)}, patient);
    for (const std::size_t i : {1U, 2U, 3U}) robots.host(i).settings.lasting = 77;
    robots.start();
    EXPECT_TRUE(robots.team.settle(seconds(30)));
    for (int round = 0; round < 10; ++round) {
      robots.world.run_for(seconds(30));
      robots.host(2).crash();
      robots.world.run_for(milliseconds(30));
      robots.host(2).switch_on();
    }
    EXPECT_TRUE(robots.team.settle(seconds(30)));
    // One answer in a thousand does not come through in time (wrong_successions); there are about two hundred.
    EXPECT_LE(robots.team.false_departures().size(), loss == 0 ? 0U : 3U);
  }
}

}  // namespace
}  // namespace geminga::sim
