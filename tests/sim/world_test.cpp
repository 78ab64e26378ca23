// The simulated air, clocks and hosts do what they say.
#include "sim/world.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "sim/agenda.hpp"
#include "sim/clock.hpp"
#include "sim/links.hpp"
#include "sim/robots.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::nanoseconds;
using std::chrono::seconds;
using testing::ElementsAre;

base::Instant at(base::Duration time) { return base::Instant(time); }

TEST(Agenda, GivesWhatIsFirstAndAtOneInstantWhatWasEnteredFirst) {
  Agenda<int> agenda;
  EXPECT_EQ(agenda.next(), base::never);
  agenda.add(at(seconds(2)), 3);
  agenda.add(at(seconds(1)), 1);
  agenda.add(at(seconds(2)), 4);
  agenda.add(at(seconds(1)), 2);
  std::vector<int> order;
  while (!agenda.is_empty()) order.push_back(agenda.take());
  EXPECT_THAT(order, ElementsAre(1, 2, 3, 4));
}

TEST(Clock, ShowsAnInstantFromTheTimeOnThatItSaysForIt) {
  for (const std::int64_t drift : {-50'000, -537, -1, 0, 1, 42, 50'000}) {
    Clock clock(seconds(7));
    clock.set_drift(at(seconds(1)), drift);
    for (const base::Duration time : {base::Duration(1), base::Duration(999'999'937), base::Duration(minutes(1440))}) {
      const base::Instant local = clock.local(at(seconds(1))) + time;
      const base::Instant world = clock.world(local);
      EXPECT_GE(clock.local(world), local) << drift;
      EXPECT_LT(clock.local(world - nanoseconds(1)), local) << drift;
    }
  }
}

TEST(Clock, StandsStillWhileItIsStopped) {
  Clock clock(seconds(7));
  clock.stop(at(seconds(2)));
  EXPECT_EQ(clock.local(at(seconds(50))), at(seconds(9)));
  clock.go_on(at(seconds(50)));
  EXPECT_EQ(clock.local(at(seconds(51))), at(seconds(10)));
}

TEST(Links, AreInABurstForTheShareOfTheTimeThatTheAirSays) {
  for (const double share : {0.05, 0.3}) {
    Links links;
    base::Random random(World::seed_or(3));
    const Air air = {.burst = share, .burst_length = milliseconds(200)};
    int bursts = 0;
    int missed = 0;
    bool was = false;
    for (int step = 0; step < 200'000; ++step) {
      const bool is = links.is_in_burst(1, at(milliseconds(10 * step)), air, random);
      missed += is ? 1 : 0;
      bursts += is && !was ? 1 : 0;
      was = is;
    }
    EXPECT_NEAR(missed / 200'000.0, share, share / 5);
    EXPECT_NEAR(missed * 10.0 / bursts, 200, 30);
  }
}

/// Two hosts that see each other.
struct Pair {
  explicit Pair(const Air& air) : robots(World::seed_or(60), 2, air, {.missing = seconds(60), .surplus = seconds(60)}) {
    robots.start();
    EXPECT_TRUE(robots.team.settle(seconds(10)));
  }
  Robots robots;
};

TEST(World, LetsNothingThroughOneWayOfACutLink) {
  Pair pair({});
  pair.robots.world.cut(pair.robots.host(0), pair.robots.host(1));
  pair.robots.world.run_for(seconds(20));
  EXPECT_FALSE(pair.robots.module(0).client().view(4).empty()) << "the first one hears the second one";
  const auto& view = pair.robots.module(4).client().view(4);
  for (const auto& [service, event] : view) EXPECT_NE(event.value("address"), "10.0.0.1") << service;
}

TEST(World, WakesASleepingHostAsItWas) {
  Pair pair({});
  const auto before = pair.robots.host(1).now();
  pair.robots.host(1).pause(Host::Pause::asleep);
  pair.robots.world.run_for(minutes(1));
  EXPECT_EQ(pair.robots.host(1).now(), before);
  pair.robots.host(1).resume();
  EXPECT_FALSE(pair.robots.team.is_right()) << "the other one has taken it for gone";
  EXPECT_TRUE(pair.robots.team.settle(seconds(10)));
}

TEST(World, KeepsSoManyDatagramsForAStoppedProcessAsASocketHolds) {
  Pair pair({});
  pair.robots.host(1).pause(Host::Pause::stopped);
  pair.robots.world.run_for(minutes(1));
  pair.robots.host(1).resume();
  EXPECT_TRUE(pair.robots.team.settle(seconds(10)));
}

TEST(World, TurnsBitsOver) {
  Pair pair({});
  pair.robots.world.air.flip = 1;
  pair.robots.team.is_excused = true;
  std::vector<std::string> sent;
  pair.robots.world.on_transmit = [&](const Host&, std::string_view datagram) { sent.emplace_back(datagram); };
  pair.robots.team.ledger().tampered_until(base::never);
  bool was_wrong = false;
  for (int second = 0; second < 120; ++second) {
    pair.robots.world.run_for(seconds(1));
    was_wrong |= !pair.robots.team.is_right();
  }
  EXPECT_FALSE(sent.empty());
  EXPECT_TRUE(was_wrong) << "nothing comes through as it was sent";
}

TEST(World, RunsTheSameWhetherItsHostsShareWhatIsEqualOrNot) {
  const auto trace = [](bool is_shared) {
    Robots robots(World::seed_or(61), 5, {.loss = 0.3, .flip = 0.01});
    robots.team.is_excused = true;
    robots.team.ledger().tampered_until(base::never);
    for (const auto& host : robots.world.hosts()) {
      if (is_shared) continue;
      host->settings.shared = nullptr;
      host->settings.shared_entries = nullptr;
    }
    robots.start();
    robots.world.run_for(seconds(20));
    robots.module(0).offer("news", stream);
    robots.host(1).crash();
    robots.world.run_for(seconds(20));
    return robots.world.trace_hash();
  };
  EXPECT_EQ(trace(true), trace(false));
}

}  // namespace
}  // namespace geminga::sim
