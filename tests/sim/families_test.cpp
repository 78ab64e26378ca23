// Teams of which some speak IPv4 and IPv6 and some only one of them: who hears whom, and what is said twice for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "discovery/announcement/codec.hpp"
#include "discovery/membership/schedule/schedule.hpp"
#include "discovery/sealing/rig.hpp"
#include "sim/robots.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

/// The number of IPv6 on a link that carries both families.
constexpr std::uint32_t ipv6 = 6;

constexpr Bounds patient = {.missing = seconds(30), .surplus = seconds(30)};

struct Families : Robots {
  explicit Families(std::uint64_t seed, Air air = {}) : Robots(World::seed_or(seed), 0, air, patient) {}

  Host& add_both(const std::string& name) {
    Host& host = add(name);
    host.attach_ipv6("eth0", ipv6);
    return host;
  }
  Host& add_ipv6(const std::string& name) {
    Host& host = add(name);
    host.detach("eth0");
    host.attach_ipv6("eth0", ipv6);
    return host;
  }
  void switch_all_on() {
    for (const auto& host : world.hosts()) host->switch_on();
    for (const auto& module : team.modules()) module->run();
  }
  /// Datagrams that a host says over IPv6 in this time.
  std::uint64_t said_on_ipv6(const Host& host, base::Duration time) {
    const std::uint64_t before = host.datagrams_sent_on(ipv6);
    world.run_for(time);
    return host.datagrams_sent_on(ipv6) - before;
  }
};

TEST(Families, WhereAllSpeakIpv4NothingButTheFirstClaimIsSaidOverIpv6) {
  Families robots(1, {.loss = 0.3});
  for (const char* name : {"a", "b", "c"}) robots.add_both(name);
  robots.switch_all_on();
  robots.world.run_for(minutes(5));
  EXPECT_TRUE(robots.team.settle(seconds(10)));
  for (const auto& host : robots.world.hosts()) EXPECT_EQ(host->datagrams_sent_on(ipv6), 1U) << robots.world.when();
  EXPECT_THAT(robots.world.ask(robots.host(0), "interfaces"),
              testing::Contains(testing::AllOf(testing::HasSubstr("name=eth0"), testing::HasSubstr("ipv6=silent"))));
}

TEST(Families, WhoSpeaksIpv6AloneHearsThoseThatSpeakBothAndIsHeard) {
  Families robots(2);
  robots.add_both("a");
  robots.add_both("b");
  Host& alone = robots.add_ipv6("c");
  robots.switch_all_on();
  robots.world.run_for(milliseconds(300));
  EXPECT_TRUE(robots.team.is_right()) << robots.world.when() << "\n" << robots.team.complaints();
  robots.world.run_for(minutes(2));
  EXPECT_TRUE(robots.team.is_right()) << robots.world.when() << "\n" << robots.team.complaints();
  for (std::size_t i : {0U, 1U}) {
    const auto said = robots.said_on_ipv6(robots.host(i), minutes(1));
    EXPECT_GE(said, 25U);
    EXPECT_LE(said, 35U) << "a presence in an interval";
  }
  EXPECT_THAT(
      robots.world.ask(alone, "participants"),
      testing::Contains(testing::AllOf(testing::HasSubstr("name=a"), testing::HasSubstr("addresses=fe80::1%eth0 "))))
      << "an address that it can reach";
  EXPECT_THAT(
      robots.world.ask(robots.host(1), "participants"),
      testing::Contains(testing::AllOf(testing::HasSubstr("name=a"), testing::HasSubstr("addresses=10.0.0.1,"))))
      << "those that speak both use IPv4 with each other";
}

TEST(Families, WhoComesLaterOrUnderLossIsHeardAsWell) {
  for (const double loss : {0.0, 0.3, 0.5}) {
    Families robots(3, {.loss = loss, .longest_delay = milliseconds(5)});
    for (const char* name : {"a", "b", "c", "d"}) robots.add_both(name);
    robots.switch_all_on();
    robots.world.run_for(minutes(1));
    Host& late = robots.add_ipv6("e");
    late.switch_on();
    for (const auto& module : robots.team.modules()) {
      if (module->client().host() == nullptr) module->run();
    }
    EXPECT_TRUE(robots.team.settle(loss == 0 ? milliseconds(300) : seconds(10))) << loss;
    robots.world.run_for(minutes(10));
    EXPECT_TRUE(robots.team.settle(seconds(5))) << loss;
    // At 50 % a living one of ten may be taken for gone once in an hour, and one of five as well.
    EXPECT_LE(robots.team.false_departures().size(), loss < 0.5 ? 0U : 1U) << loss;
  }
}

TEST(Families, WhenWhoSpeaksIpv6AloneHasGoneNobodySpeaksItAnyMore) {
  for (const bool says_goodbye : {true, false}) {
    Families robots(4, {.loss = 0.1});
    for (const char* name : {"a", "b", "c", "d"}) robots.add_both(name);
    Host& alone = robots.add_ipv6("e");
    robots.switch_all_on();
    robots.world.run_for(minutes(1));
    if (says_goodbye) {
      alone.stop();
    } else {
      alone.crash();
    }
    robots.world.run_for(seconds(12));
    EXPECT_EQ(robots.said_on_ipv6(robots.host(0), minutes(5)), 0U)
        << "those that speak both do not keep each other at it";
  }
}

TEST(Families, SealedTheyProveThemselvesOverIpv6AsWell) {
  for (const double loss : {0.0, 0.3}) {
    Families robots(5, {.loss = loss, .longest_delay = milliseconds(5)});
    robots.add_both("a");
    robots.add_both("b");
    robots.add_ipv6("c");
    for (const auto& host : robots.world.hosts()) {
      host->settings.sealing = sealing::policy(sealing::Mode::encrypted, {1});
    }
    robots.switch_all_on();
    EXPECT_TRUE(robots.team.settle(loss == 0 ? milliseconds(400) : milliseconds(5000))) << loss;
    robots.world.run_for(minutes(2));
    EXPECT_TRUE(robots.team.settle(seconds(5))) << loss;
    EXPECT_LE(robots.said_on_ipv6(robots.host(0), minutes(1)), 60U) << "nothing is owed for ever";
    robots.host(2).crash();
    robots.world.run_for(seconds(12));
    const auto quiet = robots.host(0).datagrams_sent();
    EXPECT_EQ(robots.said_on_ipv6(robots.host(0), minutes(1)), 0U);
    EXPECT_LE(robots.host(0).datagrams_sent() - quiet, 60U + membership::search_capacity) << "who was lost is sought";
  }
}

TEST(Families, ALieOverIpv6AboutWhoSpeaksBothIsContradictedThere) {
  Families robots(6);
  robots.add_both("a");
  robots.add_ipv6("b");
  robots.switch_all_on();
  robots.world.run_for(seconds(10));
  std::string goodbye;
  robots.world.on_transmit = [&](const Host& sender, std::string_view datagram) {
    if (sender.name() == "a") goodbye = datagram;
  };
  robots.world.run_for(seconds(3));
  auto lie = announcement::decode(std::as_bytes(std::span(goodbye)));
  ASSERT_TRUE(lie);
  ASSERT_NE(lie->link & announcement::ipv6_side_bit, 0U) << "the IPv6 side is spoken on last";
  lie->kind = announcement::Kind::goodbye;
  lie->sequence += 10;
  lie->name = "a";
  const auto forged = announcement::encode(*lie);
  const auto before = robots.host(0).datagrams_sent_on(ipv6);
  robots.world.inject(
      "fe80::1", std::string_view(reinterpret_cast<const char*>(forged.front().data()), forged.front().size()), ipv6);
  robots.world.run_for(milliseconds(100));
  EXPECT_GT(robots.host(0).datagrams_sent_on(ipv6), before);
  robots.world.run_for(seconds(5));
  EXPECT_TRUE(robots.team.is_right()) << robots.team.complaints();
}

TEST(Families, OfWhomOneSpeaksIpv6AloneNobodyIsTakenForDeaf) {
  Families robots(7);
  robots.add_both("a");
  robots.add_both("b");
  robots.add_ipv6("c");
  robots.switch_all_on();
  robots.world.run_for(minutes(1));
  for (const auto& host : robots.world.hosts()) {
    for (const std::string& line : robots.world.ask(*host, "participants")) {
      EXPECT_EQ(line.find("hears_us"), std::string::npos) << line;
    }
  }
}

}  // namespace
}  // namespace geminga::sim
