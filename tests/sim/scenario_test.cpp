// Scenarios of a team, and what must hold in each of them all the time. GEMINGA_SEED chooses another seed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "discovery/membership/claim/identifier_claim.hpp"
#include "discovery/membership/schedule/deadline.hpp"
#include "sim/robots.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

TEST(Scenario, TenParticipantsLiveThroughAnHourWithLossACrashAndARestart) {
  Robots robots(World::seed_or(1), 10, {.loss = 0.05, .duplicate = 0.02, .longest_delay = milliseconds(40)});
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  keep_changing(robots, seconds(20));
  robots.world.run_for(minutes(20));
  robots.host(3).crash();
  robots.world.run_for(minutes(5));
  robots.host(3).switch_on();
  robots.world.run_for(minutes(20));
  robots.host(7).stop();
  robots.world.run_for(minutes(1));
  robots.host(7).switch_on();
  robots.world.run_for(minutes(14));
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  EXPECT_THAT(robots.team.false_departures(), testing::IsEmpty());
  EXPECT_GT(robots.team.events(), 1000U) << robots.world.when();
}

TEST(Scenario, TheSameSeedGivesTheSameRunAndAnotherSeedAnother) {
  const auto trace_of = [](std::uint64_t seed) {
    Robots robots(seed, 4, {.loss = 0.2, .duplicate = 0.1, .longest_delay = milliseconds(30)});
    robots.start();
    keep_changing(robots, seconds(1));
    robots.world.run_for(minutes(1));
    robots.host(1).crash();
    robots.world.run_for(minutes(1));
    return robots.world.trace_hash();
  };
  const std::uint64_t seed = World::seed_or(3);
  EXPECT_EQ(trace_of(seed), trace_of(seed)) << "GEMINGA_SEED=" << seed;
  EXPECT_NE(trace_of(seed), trace_of(seed + 1)) << "GEMINGA_SEED=" << seed;
}

TEST(Scenario, NobodyIsTakenForDeadInAnHourAtOnePercentLoss) {
  Robots robots(World::seed_or(5), 5, {.loss = 0.01, .duplicate = 0.05, .longest_delay = milliseconds(100)});
  robots.start();
  robots.world.run_for(minutes(60));
  EXPECT_TRUE(robots.team.is_right()) << robots.world.when() << "\n" << robots.team.complaints();
  EXPECT_THAT(robots.team.false_departures(), testing::IsEmpty());
}

TEST(Scenario, AtThirtyPercentLossViewsAreRightWithinSecondsAndEveryMistakeIsMended) {
  Robots robots(World::seed_or(6), 10, {.loss = 0.3, .duplicate = 0.05, .longest_delay = milliseconds(100)},
                {.missing = seconds(15), .surplus = seconds(25)});
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(15)));
  keep_changing(robots, seconds(5));
  robots.world.run_for(minutes(5));
  EXPECT_TRUE(robots.team.settle(seconds(15)));
}

TEST(Scenario, ANewServiceIsToldEverywhereWithinFiveMilliseconds) {
  Robots robots(World::seed_or(6), 10, {});
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  robots.world.run_for(seconds(10));
  robots.module(0).offer("ball", stream);
  robots.world.run_for(milliseconds(5));
  EXPECT_TRUE(robots.team.is_right()) << robots.world.when() << "\n" << robots.team.complaints();
}

TEST(Scenario, ACleanEndIsToldEverywhereWithinFiveMilliseconds) {
  Robots robots(World::seed_or(7), 10, {});
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  robots.world.run_for(seconds(10));
  robots.host(4).stop();
  robots.world.run_for(milliseconds(5));
  EXPECT_TRUE(robots.team.is_right()) << robots.world.when() << "\n" << robots.team.complaints();
  robots.world.run_for(seconds(1));
  EXPECT_FALSE(robots.host(4).is_on()) << "stop() has not come to its end. " << robots.world.when();
}

TEST(Scenario, ACrashIsToldByTheDeadlineAndNotBefore) {
  Robots robots(World::seed_or(8), 10, {});
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  robots.world.run_for(minutes(1));
  robots.host(4).crash();
  const auto interval = robots.host(4).settings.interval;
  // The last announcement may be as old as one interval with its jitter.
  const base::Duration longest = membership::patience(interval, {});
  robots.world.run_for(longest - interval - interval / 4);
  EXPECT_FALSE(robots.team.is_right()) << "told before the deadline. " << robots.world.when();
  robots.world.run_for(interval + interval / 4 + milliseconds(100));
  EXPECT_TRUE(robots.team.is_right()) << robots.world.when() << "\n" << robots.team.complaints();
}

TEST(Scenario, AHostThatReturnsAtOnceIsNotMixedUpWithItsEarlierLife) {
  Robots robots(World::seed_or(9), 5, {.loss = 0.05});
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  for (int i = 0; i < 10; ++i) {
    robots.host(2).crash();
    robots.world.run_for(milliseconds(50));
    robots.host(2).switch_on();
    robots.world.run_for(seconds(40));
    EXPECT_TRUE(robots.team.settle(seconds(10)));
  }
}

TEST(Scenario, ViewsAreRightAgainAfterTheNetworkWasCut) {
  Robots robots(World::seed_or(10), 6, {.loss = 0.05});
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  robots.team.is_excused = true;
  for (const std::size_t index : {0U, 1U, 2U}) robots.host(index).set_island(1);
  robots.world.run_for(seconds(60));
  EXPECT_TRUE(robots.team.is_right()) << "both halves know that the other is gone. " << robots.team.complaints();
  robots.module(0).offer("ball", stream);
  for (const std::size_t index : {0U, 1U, 2U}) robots.host(index).set_island(0);
  robots.world.run_for(seconds(5));
  robots.team.is_excused = false;
  EXPECT_TRUE(robots.team.settle(seconds(5)));
}

TEST(Scenario, AModuleThatEndsHasWithdrawnEverywhere) {
  Robots robots(World::seed_or(11), 5, {});
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  robots.module(3).end();
  robots.world.run_for(milliseconds(5));
  EXPECT_TRUE(robots.team.is_right()) << robots.world.when() << "\n" << robots.team.complaints();
}

/// Two seeds whose claims begin with the same identifier, as one in 2^32 pairs does.
std::pair<std::uint64_t, std::uint64_t> clashing_seeds() {
  std::map<ParticipantId, std::uint64_t> seen;
  for (std::uint64_t seed = 1;; ++seed) {
    membership::IdentifierClaim claim(seed);
    claim.start(base::Instant());
    const auto [other, is_new] = seen.emplace(claim.id(), seed);
    if (!is_new) return {other->second, seed};
  }
}

/// The second draw of a participant seeds its claim (participant/air/announcer.cpp).
void force_claim(Host& host, std::uint64_t claim_seed) { host.forced_bits = {host.random_bits(), claim_seed}; }

/// Asks every daemon who it is, so that the checker of identifiers knows.
void keep_asking(Robots& robots) {
  robots.world.every(milliseconds(500), [&robots] {
    for (const auto& module : robots.team.modules()) module->client().say("0 sys hello");
  });
}

TEST(Scenario, TwoThatClaimTheSameIdentifierAtOnceGetDifferentOnes) {
  Robots robots(World::seed_or(12), 3, {});
  const auto [one, other] = clashing_seeds();
  force_claim(robots.host(0), one);
  force_claim(robots.host(1), other);
  keep_asking(robots);
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  robots.world.run_for(minutes(1));
  EXPECT_NE(robots.module(0).client().participant(), robots.module(3).client().participant()) << robots.world.when();
}

TEST(Scenario, TwoOwnersOfOneIdentifierThatMeetTakeNewOnesAndServicesComeBack) {
  Robots robots(World::seed_or(13), 6, {.loss = 0.05});
  const auto [one, other] = clashing_seeds();
  force_claim(robots.host(0), one);
  force_claim(robots.host(1), other);
  robots.host(1).set_island(1);
  keep_asking(robots);
  robots.team.is_excused = true;
  robots.start();
  robots.world.run_for(seconds(20));
  ASSERT_EQ(robots.module(0).client().participant(), robots.module(3).client().participant()) << "they do not clash";
  robots.host(1).set_island(0);
  robots.world.run_for(seconds(5));
  robots.team.is_excused = false;
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  robots.world.run_for(minutes(2));
  EXPECT_NE(robots.module(0).client().participant(), robots.module(3).client().participant()) << robots.world.when();
}

TEST(Scenario, AHostOnTwoNetworksIsToldOfWithTheAddressOfEach) {
  World world(World::seed_or(14));
  Team team(world);
  Host& left = world.add_host("left", 1);
  Host& middle = world.add_host("middle", 1);
  middle.attach("eth1", 2);
  Host& right = world.add_host("right", 2);
  for (Host* host : {&left, &middle, &right}) host->switch_on();
  Client& provider = world.add_client("provider");
  Client& consumer_left = world.add_client("left");
  Client& consumer_right = world.add_client("right");
  provider.connect(middle);
  consumer_left.connect(left);
  consumer_right.connect(right);
  provider.say("1 pub create mode=otm/stream text=map port=9");
  consumer_left.say("1 sub create mode=otm/stream text=map");
  consumer_right.say("1 sub create mode=otm/stream text=map");
  world.run_for(seconds(2));
  ASSERT_EQ(consumer_left.view(1).size(), 1U);
  ASSERT_EQ(consumer_right.view(1).size(), 1U);
  EXPECT_EQ(consumer_left.view(1).begin()->second.value("address"), "10.0.1.2");
  EXPECT_EQ(consumer_right.view(1).begin()->second.value("address"), "10.0.2.2");
  // The network on the right goes: only those there lose it, and get it back when it returns.
  middle.detach("eth1");
  world.run_for(minutes(1));
  EXPECT_EQ(consumer_left.view(1).size(), 1U);
  EXPECT_EQ(consumer_right.view(1).size(), 0U);
  middle.attach("eth1", 2);
  world.run_for(milliseconds(5));
  EXPECT_EQ(consumer_right.view(1).size(), 1U);
}

TEST(Scenario, ParticipantsOfAnotherGroupAreNotHeard) {
  World world(World::seed_or(15));
  Host& ours = world.add_host("ours");
  Host& theirs = world.add_host("theirs");
  theirs.settings.group = "other-team";
  ours.switch_on();
  theirs.switch_on();
  Client& provider = world.add_client("provider");
  Client& consumer = world.add_client("consumer");
  provider.connect(theirs);
  consumer.connect(ours);
  provider.say("1 pub create mode=otm/stream text=map port=9");
  consumer.say("1 sub create mode=otm/stream text=map");
  world.run_for(seconds(10));
  EXPECT_TRUE(consumer.view(1).empty());
  consumer.lines.clear();
  consumer.say("2 query participants");
  world.run_for(milliseconds(1));
  ASSERT_EQ(consumer.lines.size(), 2U);
  EXPECT_EQ(consumer.lines.back(), "2 msg end count=1");
}

TEST(Scenario, RandomAndTruncatedDatagramsHurtNobody) {
  Robots robots(World::seed_or(16), 3, {});
  robots.start();
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  base::Random& random = robots.world.random();
  for (int i = 0; i < 20'000; ++i) {
    std::string bytes(random.below(1300), '\0');
    for (char& one : bytes) one = static_cast<char>(random.next());
    robots.host(0).receive(robots.host(0).ports().front().index, "10.0.0.66", bytes);
  }
  robots.world.run_for(minutes(1));
  EXPECT_TRUE(robots.team.is_right()) << robots.world.when() << "\n" << robots.team.complaints();
}

}  // namespace
}  // namespace geminga::sim
