// Teams on several links with relays between them: who meets whom, how soon, and who is given up when.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/schedule/deadline.hpp"
#include "discovery/sealing/rig.hpp"
#include "sim/robots.hpp"
#include "sim/word_watch.hpp"
#include "support/rounds.hpp"

namespace geminga::sim {
namespace {

using sealing::Mode;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

constexpr base::Duration interval = seconds(2);

/// The checker of deaths: nobody is known for longer than the longest deadline behind so many relays allows.
constexpr Bounds behind(int relays) {
  const auto longest = static_cast<int>(membership::longest_deadline);
  return {.missing = seconds(30), .surplus = (longest + relays) * interval + milliseconds(500)};
}

/// Links are numbered from 0; all robots seal with one key.
struct Linked : Robots {
  Linked(std::uint64_t seed, Air air, int relays = 1)
      : Robots(World::seed_or(seed), 0, air, behind(relays)), watch(world, sealing::key_of(1)) {}

  Host& add_on(const std::string& name, std::uint32_t link) {
    Host& host = add_bare(name, link);
    furnish(team, host);
    return host;
  }
  Host& add_relay(const std::string& name, const std::vector<std::uint32_t>& links) {
    Host& host = add_bare(name, links.front());
    for (std::size_t i = 1; i < links.size(); ++i) host.attach("eth" + std::to_string(i), links[i]);
    host.settings.relay = true;
    return host;
  }
  void switch_all_on() {
    for (const auto& host : world.hosts()) host->switch_on();
    for (const auto& module : team.modules()) module->run();
  }
  base::Duration until_right(base::Duration at_most) {
    const auto begin = world.now();
    while (!team.is_right() && world.now() - begin < at_most) world.run_for(milliseconds(10));
    return world.now() - begin;
  }
  std::string participants(Host& host) {
    std::string all;
    for (const std::string& line : world.ask(host, "participants")) all += line + "\n";
    return all;
  }

  WordWatch watch;

 private:
  Host& add_bare(const std::string& name, std::uint32_t link) {
    Host& host = world.add_host(name, link);
    host.settings.sealing = sealing::policy(Mode::encrypted, {1});
    return host;
  }
};

double ms(base::Duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

TEST(Relay, LetsTwoLinksMeetAndLoseEachOther) {
  Linked robots(1, {});
  Host& a = robots.add_on("a", 0);
  Host& c = robots.add_on("c", 1);
  robots.add_relay("b", {0, 1});
  robots.switch_all_on();
  EXPECT_LE(ms(robots.until_right(seconds(10))), 1500) << robots.team.complaints();
  robots.world.run_for(minutes(1));
  EXPECT_TRUE(robots.team.is_right()) << robots.team.complaints();
  EXPECT_THAT(robots.team.false_departures(), testing::IsEmpty());
  EXPECT_THAT(robots.participants(a), testing::ContainsRegex("name=c .* hops=1 path=b"));
  EXPECT_THAT(robots.world.ask(a, "services"), testing::Contains(testing::EndsWith("hops=1 path=b")));
  EXPECT_THAT(robots.world.ask(a, "requests"), testing::Contains(testing::EndsWith("hops=1 path=b")));
  c.crash();
  // The deadline of one link where nothing is lost, and one interval for the relay.
  robots.world.run_for(std::chrono::duration_cast<base::Duration>((membership::shortest_deadline + 1) * interval));
  EXPECT_THAT(robots.participants(a), testing::Not(testing::HasSubstr("name=c"))) << robots.participants(a);
}

std::string lines_of(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

/// A consumer on one link and a provider on the other, while the route between them goes and comes, and while the
/// provider is behind a translation of addresses. A host of the same link is never judged.
TEST(Relay, TellsNoServiceThatCannotBeReachedAndTellsItAgain) {
  using env::RouteKind;
  using testing::HasSubstr;
  using testing::Not;
  Linked robots(11, {});
  World& world = robots.world;
  const auto add = [&](const std::string& name, std::uint32_t link) -> Host& {
    Host& host = world.add_host(name, link);
    host.settings.sealing = sealing::policy(Mode::encrypted, {1});
    return host;
  };
  Host& a = add("a", 0);
  Host& near = add("near", 0);
  Host& c = add("c", 1);
  robots.add_relay("b", {0, 1});
  const std::string behind = c.ports().front().address;
  RouteKind way = RouteKind::none;
  const auto routes = [&way](std::string_view) { return way; };
  robots.switch_all_on();
  a.set_routes(routes);
  Client& consumer = world.add_client("consumer");
  consumer.connect(a);
  consumer.say("1 sub create mode=otm/pubsub text=ball");
  consumer.say("2 sub create mode=otm/pubsub text=ball reach=any");
  Client& far = world.add_client("far");
  far.connect(c);
  far.say("1 pub create mode=otm/pubsub text=ball port=5000");
  far.say("2 pub create mode=otm/pubsub text=ball port=5001 address=203.0.113.9");
  Client& by = world.add_client("by");
  by.connect(near);
  by.say("1 pub create mode=otm/pubsub text=ball port=5002");
  const auto said = [&] {
    world.run_for(seconds(5));
    return lines_of(std::exchange(consumer.lines, {}));
  };
  const std::string first = said();
  EXPECT_THAT(first, Not(testing::ContainsRegex("1 pub add [^\n]*port=5000"))) << first;
  EXPECT_THAT(first, testing::ContainsRegex("2 pub add [^\n]*port=5000[^\n]*hops=1 path=b reachable=no\r?\n")) << first;
  EXPECT_THAT(first, testing::ContainsRegex("1 pub add [^\n]*port=5001")) << "a stated address is not judged";
  EXPECT_THAT(first, testing::ContainsRegex("1 pub add [^\n]*port=5002")) << "a host of the link is not judged";
  EXPECT_THAT(lines_of(far.lines), testing::ContainsRegex("1 sub add [^\n]*participant_name=a hops=1"))
      << "providers are told";
  EXPECT_THAT(robots.participants(a), testing::ContainsRegex("name=c [^\n]*reachable=no"));
  EXPECT_THAT(lines_of(world.ask(a, "services")), testing::ContainsRegex("port=5000[^\n]*reachable=no"));
  EXPECT_THAT(lines_of(world.ask(a, "services")), Not(testing::ContainsRegex("port=500[12][^\n]*reachable=no")));

  way = RouteKind::specific;
  a.set_routes(routes);
  const std::string back = said();
  EXPECT_THAT(back, testing::ContainsRegex("1 pub add [^\n]*port=5000[^\n]*path=b\r?\n")) << back;
  EXPECT_THAT(back, testing::ContainsRegex("2 pub modify [^\n]*port=5000[^\n]*path=b\r?\n")) << back;

  way = RouteKind::none;
  a.set_routes(routes);
  const std::string gone = said();
  EXPECT_THAT(gone, testing::ContainsRegex("1 pub del [^\n]*reason=unreachable")) << gone;
  EXPECT_THAT(gone, testing::ContainsRegex("2 pub modify [^\n]*reachable=no")) << gone;

  // The default route leads there, until words come from another address than the one that is announced.
  way = RouteKind::fallback;
  a.set_routes(routes);
  EXPECT_THAT(said(), testing::ContainsRegex("1 pub add [^\n]*port=5000"));
  EXPECT_THAT(robots.participants(a), Not(HasSubstr("observed=")));
  c.seen_as = "198.51.100.7";
  far.say("3 pub create mode=oto text=other port=5003");  // a word is passed on
  EXPECT_THAT(said(), testing::ContainsRegex("1 pub del [^\n]*reason=unreachable"));
  EXPECT_THAT(robots.participants(a),
              testing::ContainsRegex("name=c addresses=" + behind + " [^\n]*observed=198.51.100.7 [^\n]*reachable=no"));
}

TEST(Relay, IsNotPossibleWithoutAKeyWhereNobodyIsNamed) {
  Linked robots(2, {});
  Host& a = robots.add_on("a", 0);
  robots.add_on("c", 1);
  robots.add_relay("b", {0, 1});
  for (const auto& host : robots.world.hosts()) host->settings.sealing = {};
  robots.team.is_excused = true;
  robots.switch_all_on();
  robots.world.run_for(seconds(20));
  EXPECT_THAT(robots.participants(a),
              testing::AllOf(testing::HasSubstr("name=b"), testing::Not(testing::HasSubstr("name=c"))));
}

/// The relay in the middle is far slower than those on both sides of it: signs of life are as late as all relays on the
/// way make them, and not only the last.
TEST(Relay, LosesNobodyBehindSlowAndQuickRelays) {
  Linked robots(9, {.loss = 0.1}, 2);
  Host& a = robots.add_on("a", 0);
  Host& c = robots.add_on("c", 2);
  Host& slow = robots.add_relay("slow", {0, 1});
  Host& quick = robots.add_relay("quick", {1, 2});
  a.settings.interval = c.settings.interval = seconds(1);
  slow.settings.interval = seconds(5);
  quick.settings.interval = milliseconds(200);
  robots.switch_all_on();
  robots.until_right(seconds(30));
  robots.world.run_for(minutes(2));
  EXPECT_TRUE(robots.team.is_right()) << robots.team.complaints();
  EXPECT_THAT(robots.team.false_departures(), testing::IsEmpty());
}

/// Octets a second that all say together in a quiet minute.
double quiet_octets(Linked& robots) {
  robots.switch_all_on();
  robots.world.run_for(minutes(1));
  EXPECT_TRUE(robots.team.is_right()) << robots.team.complaints();
  const auto before = robots.world.datagram_bytes();
  robots.world.run_for(minutes(1));
  return static_cast<double>(robots.world.datagram_bytes() - before) / 60;
}

TEST(Relay, MakesThirtyHostsOnThreeLinksCostAtMostTwiceWhatTheyCostOnOne) {
  Linked one(3, {});
  for (int i = 0; i < 29; ++i) one.add_on("r" + std::to_string(i), 0);
  one.add_relay("base", {0});
  const double together = quiet_octets(one);
  Linked three(3, {});
  for (int i = 0; i < 29; ++i) three.add_on("r" + std::to_string(i), static_cast<std::uint32_t>(i % 3));
  three.add_relay("base", {0, 1, 2});
  const double apart = quiet_octets(three);
  std::cout << together << " B/s on one link, " << apart << " on three\n";
  EXPECT_LE(apart, 2 * together);
}

TEST(Relay, TellsChangesAcrossOneAndTwoRelaysUnderLoss) {
  for (const int relays : {1, 2}) {
    Linked robots(static_cast<std::uint64_t>(relays), {.loss = 0.3}, relays);
    for (std::uint32_t link = 0; link <= static_cast<std::uint32_t>(relays); ++link) {
      for (int i = 0; i < 5; ++i) robots.add_on("l" + std::to_string(link) + "-" + std::to_string(i), link);
      if (link > 0) robots.add_relay("b" + std::to_string(link), {link - 1, link});
    }
    robots.switch_all_on();
    std::cout << relays << " relays: all right after " << ms(robots.until_right(seconds(60))) << " ms, ";
    robots.world.run_for(seconds(20));
    keep_changing(robots, milliseconds(1700));
    robots.world.run_for(seconds(test::rounds(200)));
    auto told = robots.team.ledger().delays().told;
    ASSERT_FALSE(told.empty());
    std::ranges::sort(told);
    std::cout << "told p50 " << ms(told[told.size() / 2]) << " p95 " << ms(told[told.size() * 95 / 100]) << " ms, "
              << robots.team.false_departures().size() << " false departures\n";
    EXPECT_THAT(robots.team.false_departures(), testing::IsEmpty());
    EXPECT_LE(ms(told[told.size() * 95 / 100]), relays == 1 ? 150 : 400);
  }
}

TEST(Relay, IsTakenOverByAnotherBeforeAnybodyIsLost) {
  for (std::uint64_t seed = 1; seed <= test::rounds(10U); ++seed) {
    const double loss = seed % 4 < 2 ? 0 : 0.3;
    Linked robots(seed, {.loss = loss});
    for (std::uint32_t link : {0U, 1U}) {
      for (int i = 0; i < 3; ++i) robots.add_on("l" + std::to_string(link) + "-" + std::to_string(i), link);
    }
    Host& first = robots.add_relay("b1", {0, 1});
    Host& second = robots.add_relay("b2", {0, 1});
    robots.switch_all_on();
    robots.world.run_for(seconds(20));
    EXPECT_TRUE(robots.team.is_right()) << robots.team.complaints();
    const auto words = robots.watch.words();
    robots.module(0).offer("ball", stream);
    robots.world.run_for(seconds(3));
    const auto once = robots.watch.words() - words;
    (seed % 2 == 0 ? first : second).crash();
    robots.world.run_for(seconds(20));
    EXPECT_TRUE(robots.team.is_right()) << robots.team.complaints();
    EXPECT_THAT(robots.team.false_departures(), testing::IsEmpty()) << robots.world.when();
    // A relay may have missed that the other one speaks, and copies of a change are words of their own.
    EXPECT_LE(once, loss == 0 ? 12U : 48U) << "only one of them speaks, " << robots.world.when();
  }
}

/// The time after which everybody knows everybody again, once the relay between two links is back.
base::Duration healed(std::uint64_t seed, double loss) {
  Linked robots(seed, {.loss = loss});
  for (std::uint32_t link : {0U, 1U}) {
    for (int i = 0; i < 5; ++i) robots.add_on("l" + std::to_string(link) + "-" + std::to_string(i), link);
  }
  Host& relay = robots.add_relay("b", {0, 1});
  robots.switch_all_on();
  robots.world.run_for(seconds(20));
  robots.team.is_excused = true;
  relay.crash();
  robots.world.run_for(seconds(30));
  relay.switch_on();
  const auto begin = robots.world.now();
  while (robots.participants(robots.host(0)).find("name=l1-4") == std::string::npos &&
         robots.world.now() - begin < seconds(20))
    robots.world.run_for(milliseconds(10));
  robots.team.is_excused = false;
  robots.until_right(seconds(30));
  const auto time = robots.world.now() - begin;
  EXPECT_TRUE(robots.team.is_right()) << robots.team.complaints();
  return time;
}

TEST(Relay, HealsWithinASecondWhenItIsBack) {
  EXPECT_LE(ms(healed(7, 0)), 300);
  std::vector<base::Duration> times;
  for (std::uint64_t seed = 1; seed <= test::rounds(10U); ++seed) times.push_back(healed(seed, 0.3));
  std::ranges::sort(times);
  std::cout << "healed at 30 % loss: p50 " << ms(times[times.size() / 2]) << " ms, p95 "
            << ms(times[times.size() * 95 / 100]) << " ms, at most " << ms(times.back()) << " ms\n";
  EXPECT_LE(ms(times[times.size() / 2]), 700);
  EXPECT_LE(ms(times.back()), 1500);
}

/// Everything at once: robots and relays crash, stop for a while and return, on bad air, with a ring of links.
TEST(Relay, KeepsItsPromisesWhateverHappensToRelaysAndRobots) {
  for (std::uint64_t seed = 1; seed <= test::rounds(10U); ++seed) {
    Linked robots(100 + seed, {.loss = 0.2, .duplicate = 0.05, .late = 0.02}, 3);
    for (std::uint32_t link : {0U, 1U, 2U}) {
      for (int i = 0; i < 2; ++i) robots.add_on("l" + std::to_string(link) + "-" + std::to_string(i), link);
    }
    robots.add_relay("ring0", {0, 1});
    robots.add_relay("ring1", {1, 2});
    robots.add_relay("ring2", {2, 0});
    robots.add_relay("hub", {0, 1, 2});
    robots.switch_all_on();
    robots.world.run_for(seconds(2));
    keep_changing(robots, seconds(3));
    // Ways between links come and go with the relays, so views may lack somebody. Nobody who is dead may stay in them.
    robots.team.ledger().excuse_missing_until(robots.world.now() + minutes(2));
    for (int fault = 0; fault < 12; ++fault) {
      Host& host = robots.host(robots.world.random().below(robots.world.hosts().size()));
      if (!host.is_on()) {
        host.switch_on();
      } else if (robots.world.random().chance(0.5)) {
        host.crash();
      } else {
        host.stop();
      }
      robots.world.run_for(robots.world.random().between(milliseconds(100), seconds(10)));
    }
    for (const auto& host : robots.world.hosts()) {
      if (!host->is_on()) host->switch_on();
    }
    EXPECT_TRUE(robots.team.settle(seconds(40))) << robots.world.when() << robots.team.complaints();
  }
}

}  // namespace
}  // namespace geminga::sim
