// Real daemons on two links, and one between them that is a relay.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::system {
namespace {

/// Hosts 0 and 2 on a link each, and host 1 on both, which is a relay; all know each other.
void start_around_relay(Lab& lab, const Folder& folder) {
  ASSERT_EQ(refused({"--generate-key", folder.path("team.key")}).status, 0);
  lab.add_link(1, {2});
  const std::vector<std::string> flags{"--interval", "0.2", "--key-file", folder.path("team.key")};
  lab.start(0, flags);
  lab.start(1, {"--interval", "0.2", "--key-file", folder.path("team.key"), "--relay"});
  lab.start(2, flags);
  ASSERT_TRUE(lab.wait_for_participants(0, 3)) << lab.daemon(0).said();
}

/// Without a route a service behind a relay is known and not told as a match; with one it is, until that goes.
TEST(Relay, TellsAServiceWhileThereIsARouteToIt) {
  const Folder folder;
  Lab lab(3);
  if (!lab.has_namespaces()) GTEST_SKIP() << "namespaces may not be made here";
  ASSERT_NO_FATAL_FAILURE(start_around_relay(lab, folder));
  Talk provider = lab.talk(2);
  provider.say("1 pub create mode=otm/pubsub id=5 port=5000");
  Talk consumer = lab.talk(0);
  consumer.say("1 sub create mode=otm/pubsub id=5 reach=any");
  consumer.say("2 sub create mode=otm/pubsub id=5");
  EXPECT_TRUE(consumer.line_with({"1 pub add", "name=robot2", "reachable=no"}));
  lab.route(0, "10.47.18.0/24", lab.address_of(1));
  EXPECT_TRUE(consumer.line_with({"2 pub add", "name=robot2", "address=10.47.18.3"}));
  lab.end_route(0, "10.47.18.0/24");
  EXPECT_TRUE(consumer.line_with({"2 pub del", "reason=unreachable"}));
}

/// Two daemons that name each other, with a router between them that translates addresses, and default routes to it.
TEST(NamedPeer, IsNotReachableBehindATranslationOfAddresses) {
  const Folder folder;
  ASSERT_EQ(refused({"--generate-key", folder.path("team.key")}).status, 0);
  Lab lab(3);
  if (!lab.has_namespaces() || !Lab::can_lose()) GTEST_SKIP() << "namespaces or nftables are not there";
  lab.add_link(1, {2});
  const std::string outside = lab.address_of(1);
  lab.translate(1, "wlan0", Lab::address_on(1, 2));
  lab.route(0, "default", outside);
  lab.route(2, "default", Lab::address_on(1, 1));
  const std::vector<std::string> flags{"--interval", "0.2", "--key-file", folder.path("team.key"), "--peer"};
  const auto naming = [&flags](const std::string& peer) {
    std::vector<std::string> all = flags;
    all.push_back(peer);
    return all;
  };
  lab.start(0, naming(outside));
  lab.start(2, naming(lab.address_of(0)));
  ASSERT_TRUE(lab.wait_for_participants(0, 2)) << lab.daemon(0).said();
  Talk consumer = lab.talk(0);
  consumer.say("1 sub create mode=otm/stream id=5 reach=any");
  Talk provider = lab.talk(2);
  provider.say("1 pub create mode=otm/stream id=5 port=5000");
  EXPECT_TRUE(consumer.line_with({"1 pub add", "name=robot2", "address=10.47.18.3", "reachable=no"}));
  consumer.say("9 query participants");
  EXPECT_TRUE(consumer.line_with({"name=robot2", "observed=" + outside, "reachable=no"}));
}

TEST(Relay, LetsTwoLinksMeetAndLoseEachOther) {
  const Folder folder;
  Lab lab(3);
  if (!lab.has_namespaces()) GTEST_SKIP() << "namespaces may not be made here";
  ASSERT_NO_FATAL_FAILURE(start_around_relay(lab, folder));
  Talk consumer = lab.talk(0);
  consumer.say("1 sub create mode=otm/pubsub id=5 reach=any");
  Talk provider = lab.talk(2);
  provider.say("1 pub create mode=otm/pubsub id=5 port=5000");
  EXPECT_TRUE(
      consumer.line_with({"1 pub add", "name=robot2", "address=10.47.18.3", "hops=1 path=robot1 reachable=no"}));
  EXPECT_TRUE(provider.line_with({"1 sub add", "name=robot0", "hops=1 path=robot1"}));
  lab.daemon(2).signal(SIGKILL);
  EXPECT_TRUE(consumer.line_with({"1 pub del", "reason=expired"}));
  EXPECT_TRUE(lab.wait_for_participants(0, 2));
}

}  // namespace
}  // namespace geminga::system
