// Whole daemons on real sockets: a team that publishes, subscribes, leaves, dies, and loses its radio.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <algorithm>
#include <csignal>
#include <set>

#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::system {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// Flags with a short interval, so that deadlines come soon.
const std::vector<std::string> quick{"--interval", "0.1"};

/// Waits until the daemon has heard so many more datagrams, repetitions included.
[[nodiscard]] bool hears(Talk& talk, long datagrams) {
  const auto heard = [](const std::vector<std::string>& lines) {
    const std::string count = lines.empty() ? "" : field(lines[0], "datagrams_received");
    return count.empty() ? 0 : std::stol(count);
  };
  const long enough = heard(talk.query("status")) + datagrams;
  return talk.wait_until("status", [&](const auto& lines) { return heard(lines) >= enough; });
}

TEST(Team, IsToldOfAPublicationOnAnotherHost) {
  Lab lab(2);
  lab.start_all(quick);
  Talk consumer = lab.talk(1);
  consumer.say("7 sub create mode=otm/stream text=ball");
  Talk provider = lab.talk(0);
  provider.say("0 sys hello name=vision");
  provider.say("4 pub create mode=otm/stream text=ball port=5000 colour=orange");
  const auto told = consumer.line_with({"7 pub add"});
  ASSERT_TRUE(told) << lab.way();
  EXPECT_EQ(field(*told, "address"), lab.address_of(0));
  EXPECT_EQ(field(*told, "port"), "5000");
  EXPECT_EQ(field(*told, "colour"), "orange");
  EXPECT_EQ(field(*told, "name"), "vision");
  EXPECT_EQ(field(*told, "participant_name"), "robot0");
  provider.say("4 pub modify colour=yellow");
  const auto changed = consumer.line_with({"7 pub modify"});
  ASSERT_TRUE(changed);
  EXPECT_EQ(field(*changed, "service"), field(*told, "service"));
  EXPECT_EQ(field(*changed, "colour"), "yellow");
  provider.say("4 pub remove");
  const auto gone = consumer.line_with({"7 pub del"});
  ASSERT_TRUE(gone);
  EXPECT_EQ(*gone, "7 pub del service=" + field(*told, "service") + " reason=withdrawn");
}

TEST(Team, TellsAProviderOfItsConsumerAndTheEndOfIt) {
  Lab lab(2);
  lab.start_all(quick);
  Talk provider = lab.talk(0);
  provider.say("4 pub create mode=otm/pubsub id=17 port=5000");
  {
    Talk consumer = lab.talk(1);
    consumer.say("9 sub create mode=otm/pubsub id=17 port=6000");
    const auto told = provider.line_with({"4 sub add"});
    ASSERT_TRUE(told) << lab.way();
    EXPECT_EQ(field(*told, "port"), "6000");
    EXPECT_EQ(field(*told, "address"), lab.address_of(1));
  }
  const auto gone = provider.line_with({"4 sub del"});
  ASSERT_TRUE(gone) << "a consumer that disconnected has withdrawn";
  EXPECT_THAT(*gone, HasSubstr("reason=withdrawn"));
}

TEST(Team, OfSevenLosesAndDoublesNoEvent) {
  constexpr std::size_t hosts = 7;
  constexpr int services = 20;
  Lab lab(hosts);
  lab.start_all(quick);
  for (std::size_t host = 0; host < hosts; ++host) ASSERT_TRUE(lab.wait_for_participants(host, hosts)) << lab.way();
  std::vector<Talk> consumers;
  for (std::size_t host = 1; host < hosts; ++host) {
    consumers.push_back(lab.talk(host));
    for (int number = 1; number <= services; ++number) {
      consumers.back().say(std::to_string(number) + " sub create mode=otm/stream id=" + std::to_string(number));
    }
  }
  Talk provider = lab.talk(0);
  for (int number = 1; number <= services; ++number) {
    provider.say(std::to_string(number) + " pub create mode=otm/stream id=" + std::to_string(number) + " port=5000");
  }
  for (Talk& consumer : consumers) {
    std::set<std::string> told;
    for (int number = 1; number <= services; ++number) {
      const auto line = consumer.line_with({" pub add "});
      ASSERT_TRUE(line);
      EXPECT_TRUE(told.insert(line->substr(0, line->find(" provider="))).second) << "told twice: " << *line;
    }
    EXPECT_TRUE(hears(consumer, 20));
    EXPECT_THAT(consumer.lines_until_pong(), testing::IsEmpty()) << "an event more than there are services";
  }
  for (int number = 1; number <= services; ++number) provider.say(std::to_string(number) + " pub remove");
  for (Talk& consumer : consumers) {
    std::set<std::string> gone;
    for (int number = 1; number <= services; ++number) {
      const auto line = consumer.line_with({" pub del ", "reason=withdrawn"});
      ASSERT_TRUE(line);
      EXPECT_TRUE(gone.insert(*line).second) << "told twice: " << *line;
    }
    EXPECT_TRUE(hears(consumer, 20));
    EXPECT_THAT(consumer.lines_until_pong(), testing::IsEmpty());
  }
}

TEST(Team, IsToldAtOnceThatADaemonWasEnded) {
  Lab lab(3);
  lab.start_all({"--interval", "30"});  // longer than the test waits: only the goodbye can be the reason
  std::vector<Talk> consumers;
  for (const std::size_t host : {1U, 2U}) {
    consumers.push_back(lab.talk(host));
    consumers.back().say("1 sub create mode=otm/stream id=5");
  }
  Talk provider = lab.talk(0);
  provider.say("1 pub create mode=otm/stream id=5 port=5000");
  for (Talk& consumer : consumers) ASSERT_TRUE(consumer.line_with({"1 pub add"})) << lab.way();
  lab.daemon(0).signal(SIGTERM);
  for (Talk& consumer : consumers) {
    const auto gone = consumer.line_with({"1 pub del"});
    ASSERT_TRUE(gone);
    EXPECT_THAT(*gone, HasSubstr("reason=left"));
  }
  EXPECT_EQ(lab.daemon(0).wait(), 0);
  EXPECT_TRUE(provider.is_closed_by_daemon());
  for (const std::size_t host : {1U, 2U}) EXPECT_TRUE(lab.wait_for_participants(host, 2));
}

TEST(Team, NoticesThatADaemonWasKilledAndTakesItBack) {
  Lab lab(3);
  lab.start_all(quick);
  Talk consumer = lab.talk(1);
  consumer.say("1 sub create mode=otm/stream id=5");
  {
    Talk provider = lab.talk(0);
    provider.say("1 pub create mode=otm/stream id=5 port=5000");
    ASSERT_TRUE(consumer.line_with({"1 pub add"})) << lab.way();
    lab.daemon(0).signal(SIGKILL);
  }
  const auto gone = consumer.line_with({"1 pub del"});
  ASSERT_TRUE(gone);
  EXPECT_THAT(*gone, HasSubstr("reason=expired"));
  EXPECT_EQ(lab.daemon(0).wait(), 128 + SIGKILL);
  lab.start(0, quick);
  Talk provider = lab.talk(0);
  provider.say("1 pub create mode=otm/stream id=5 port=5001");
  const auto back = consumer.line_with({"1 pub add"});
  ASSERT_TRUE(back);
  EXPECT_EQ(field(*back, "port"), "5001");
  EXPECT_THAT(consumer.lines_until_pong(), testing::IsEmpty());
}

TEST(Team, LosesAHostWithItsLinkAndFindsItAgainWhenTheLinkIsBack) {
  Lab lab(3);
  lab.start_all(quick);
  std::vector<Talk> consumers;
  for (const std::size_t host : {1U, 2U}) {
    consumers.push_back(lab.talk(host));
    consumers.back().say("1 sub create mode=otm/stream id=5");
  }
  Talk provider = lab.talk(0);
  provider.say("1 pub create mode=otm/stream id=5 port=5000");
  for (Talk& consumer : consumers) ASSERT_TRUE(consumer.line_with({"1 pub add"})) << lab.way();
  lab.cut(0);
  for (Talk& consumer : consumers) {
    const auto gone = consumer.line_with({"1 pub del"});
    ASSERT_TRUE(gone);
    EXPECT_THAT(*gone, HasSubstr("reason=expired"));
  }
  lab.join(0);
  for (Talk& consumer : consumers) EXPECT_TRUE(consumer.line_with({"1 pub add"})) << lab.way();
  EXPECT_TRUE(lab.wait_for_participants(0, 3)) << "the host that was away hears the others again";
}

TEST(Team, WithoutIpv4MeetsOverIpv6) {
  Lab lab(2);
  if (!lab.has_namespaces())
    GTEST_SKIP() << "the loopback interface keeps its IPv4 and has no route for IPv6 multicast";
  for (const std::size_t host : {0U, 1U}) lab.take_ipv4(host);
  lab.start_all(quick);
  for (const std::size_t host : {0U, 1U}) EXPECT_TRUE(lab.wait_for_participants(host, 2)) << lab.way();
  const auto interfaces = lab.talk(0).query("interfaces");
  ASSERT_THAT(interfaces, SizeIs(1));
  EXPECT_THAT(field(interfaces[0], "addresses"), testing::StartsWith("fe80::"));
}

TEST(Team, WithBothFamiliesIsHeardByWhoHasNoIpv4) {
  Lab lab(3);
  if (!lab.has_namespaces()) GTEST_SKIP() << "the loopback interface keeps its IPv4";
  lab.take_ipv4(2);
  lab.start_all(quick);
  for (const std::size_t host : {0U, 1U, 2U}) ASSERT_TRUE(lab.wait_for_participants(host, 3)) << lab.way();
  Talk ipv6_alone = lab.talk(2);
  ipv6_alone.say("1 sub create mode=otm/stream id=5");
  Talk both = lab.talk(1);
  both.say("1 sub create mode=otm/stream id=5");
  Talk provider = lab.talk(0);
  provider.say("1 pub create mode=otm/stream id=5 port=5000");
  const auto told = ipv6_alone.line_with({"1 pub add"});
  ASSERT_TRUE(told);
  EXPECT_THAT(field(*told, "address"), testing::StartsWith("fe80::")) << "one that it can reach";
  const auto told_on_ipv4 = both.line_with({"1 pub add"});
  ASSERT_TRUE(told_on_ipv4);
  EXPECT_EQ(field(*told_on_ipv4, "address"), lab.address_of(0));
  const auto interfaces = lab.talk(0).query("interfaces");
  ASSERT_THAT(interfaces, SizeIs(1));
  EXPECT_EQ(field(interfaces[0], "ipv6"), "spoken");
  lab.daemon(2).signal(SIGTERM);
  for (const std::size_t host : {0U, 1U}) {
    EXPECT_TRUE(lab.talk(host).wait_until(
        "interfaces", [](const auto& lines) { return lines.size() == 1 && field(lines[0], "ipv6") == "silent"; }));
  }
}

TEST(Team, MeetsByNamedPeersWhereMulticastDoesNotPass) {
  Lab lab(2);
  const auto port = [&](std::size_t host) { return std::to_string(lab.udp_port() + 1 + static_cast<int>(host)); };
  for (const std::size_t host : {0U, 1U}) {
    const std::size_t other = 1 - host;  // groups and ports differ: only the copies for the peer can arrive
    lab.start(host, {"--interval", "0.1", "--port", port(host), "--multicast", "239.192.47.2" + std::to_string(host),
                     "--peer", lab.address_of(other) + ':' + port(other)});
  }
  for (const std::size_t host : {0U, 1U}) ASSERT_TRUE(lab.wait_for_participants(host, 2)) << lab.way();
  Talk consumer = lab.talk(1);
  consumer.say("1 sub create mode=otm/stream id=5");
  Talk provider = lab.talk(0);
  provider.say("1 pub create mode=otm/stream id=5 port=5000");
  const auto told = consumer.line_with({"1 pub add"});
  ASSERT_TRUE(told);
  EXPECT_EQ(field(*told, "address"), lab.address_of(0));
}

TEST(Team, NoticesWhomItsMulticastsDoNotReachAndMeetsItByName) {
  Lab lab(3);
  if (!lab.has_namespaces()) GTEST_SKIP() << "the loopback interface keeps nothing from anybody";
  lab.keep_multicasts_from(2);
  lab.start_all(quick);
  ASSERT_TRUE(lab.wait_for_participants(0, 3)) << lab.way();
  Talk talk = lab.talk(0);
  EXPECT_TRUE(talk.wait_until("participants", [](const auto& lines) {
    return std::ranges::any_of(lines, [](const std::string& line) {
      return field(line, "name") == "robot2" && field(line, "hears_us") == "0";
    });
  })) << testing::PrintToString(talk.query("participants"));
  const auto status = talk.query("status");
  ASSERT_THAT(status, SizeIs(1));
  EXPECT_EQ(field(status[0], "unheard_by"), "1");
  EXPECT_THAT(lab.talk(2).query("participants"), SizeIs(1));
  for (const std::size_t host : {0U, 2U}) {
    lab.daemon(host).signal(SIGTERM);
    EXPECT_EQ(lab.daemon(host).wait(), 0);
    auto flags = quick;
    flags.insert(flags.end(), {"--peer", lab.address_of(2 - host)});
    lab.start(host, flags);
  }
  EXPECT_TRUE(lab.wait_for_participants(2, 2)) << "it hears whom it names";
  EXPECT_TRUE(lab.talk(0).wait_until("status", [](const auto& lines) {
    return lines.size() == 1 && field(lines[0], "participants") == "3" && field(lines[0], "unheard_by").empty();
  }));
}

TEST(Team, KeepsGroupsApart) {
  Lab lab(3);
  lab.start(0, {"--interval", "0.1", "--group", "blue"});
  lab.start(1, {"--interval", "0.1", "--group", "yellow"});
  lab.start(2, {"--interval", "0.1", "--group", "blue"});
  EXPECT_TRUE(lab.wait_for_participants(0, 2)) << lab.way();
  EXPECT_TRUE(lab.wait_for_participants(2, 2));
  Talk yellow = lab.talk(1);
  EXPECT_TRUE(hears(yellow, 10));
  EXPECT_THAT(yellow.query("participants"), SizeIs(1));
}

TEST(Team, KnowsTheNextLifeOfWhoKeepsItsIdentityThoughNameAndAddressAreOthers) {
  const Folder folder;
  Lab lab(3);
  const std::vector<std::string> flags{"--interval", "30"};  // so that no deadline is the reason
  auto keeping = flags;
  keeping.insert(keeping.end(), {"--state-folder", folder.path("state")});
  lab.start(2, flags);
  lab.start(0, keeping);
  ASSERT_TRUE(lab.wait_for_participants(2, 2)) << lab.way();
  lab.daemon(0).signal(SIGKILL);
  EXPECT_EQ(lab.daemon(0).wait(), 128 + SIGKILL);
  lab.start(1, keeping);
  EXPECT_TRUE(lab.talk(2).wait_until("participants", [](const auto& lines) {
    return lines.size() == 2 &&
           std::ranges::any_of(lines, [](const std::string& line) { return field(line, "name") == "robot1"; });
  }));
}

TEST(Team, KeepsBothOfACopiedDisk) {
  const Folder folder;
  Lab lab(3);
  lab.start(2, quick);
  for (const std::size_t host : {0U, 1U}) {
    lab.start(host, {"--interval", "0.1", "--state-folder", folder.path("state")});
  }
  for (const std::size_t host : {0U, 1U, 2U}) EXPECT_TRUE(lab.wait_for_participants(host, 3)) << lab.way();
  EXPECT_TRUE(lab.daemon(0).wait_for("has our lasting identity, too")) << lab.daemon(0).said();
  Talk watcher = lab.talk(2);
  EXPECT_TRUE(hears(watcher, 40));
  EXPECT_THAT(watcher.query("participants"), SizeIs(3));
}

}  // namespace
}  // namespace geminga::system
