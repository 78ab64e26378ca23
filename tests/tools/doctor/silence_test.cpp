// Each cause of silence that network namespaces can make gives its finding and no other, on real daemons.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "system/folder.hpp"
#include "tools/doctor/lab_doctor.hpp"

namespace geminga::tools {
namespace {

using system::Folder;
using system::Lab;
using testing::HasSubstr;

constexpr const char* nft = "/usr/sbin/nft";
constexpr const char* ip = "/bin/ip";

/// A lab where the doctor looks at hosts of its own.
class Silence : public testing::Test {
 protected:
  void SetUp() override {
    if (!Lab(1).has_namespaces()) GTEST_SKIP() << "the doctor would look at this very host";
  }
};

/// A test with a firewall.
class SilenceByFirewall : public Silence {
 protected:
  void SetUp() override {
    Silence::SetUp();
    if (!IsSkipped() && !Lab::can_lose()) GTEST_SKIP() << "there is no nftables";
  }

  /// A team of two in which each has heard the other, and then a rule on host 0.
  static void block(Lab& lab, const std::string& hook, const std::string& rule) {
    lab.start_all({"--interval", "0.2"});
    ASSERT_TRUE(lab.wait_for_participants(0, 2));
    ASSERT_TRUE(lab.wait_for_participants(1, 2));
    must_run(lab, 0,
             {nft,
              "add table inet wall; add set inet wall ports { type inet_service; elements = { 4717 }; }; "
              "add chain inet wall it { type filter hook " +
                  hook + " priority 0; }; add rule inet wall it " + rule});
  }
};

std::string key_file(const Folder& folder, const std::string& name) {
  EXPECT_EQ(system::refused({"--generate-key", folder.path(name)}).status, 0);
  return folder.path(name);
}

TEST_F(SilenceByFirewall, InIsFoundInTheFirewallsOwnList) {
  Lab lab(2);
  block(lab, "input", "udp dport 4717 drop");
  EXPECT_TRUE(comes_to(lab, 0, {"firewall_in"}));
  EXPECT_THAT(seen_on(lab, 0), HasSubstr("nft, inet wall it: rule with handle "));
}

TEST_F(SilenceByFirewall, OutIsFoundInTheFirewallsOwnList) {
  Lab lab(2);
  block(lab, "output", "udp dport 4717 drop");
  EXPECT_TRUE(comes_to(lab, 0, {"firewall_out"}));
  EXPECT_THAT(seen_on(lab, 0), HasSubstr("nft, inet wall it: rule with handle "));
}

TEST_F(SilenceByFirewall, InIsFoundByExperimentWhereTheListDoesNotTell) {
  Lab lab(2);
  block(lab, "input", "udp dport @ports drop");
  EXPECT_TRUE(comes_to(lab, 0, {"firewall_in"}));
  EXPECT_THAT(seen_on(lab, 0), HasSubstr("nothing came in"));
}

TEST_F(SilenceByFirewall, OutIsFoundByExperimentWhereTheListDoesNotTell) {
  Lab lab(2);
  block(lab, "output", "udp dport @ports drop");
  EXPECT_TRUE(comes_to(lab, 0, {"firewall_out"}));
  EXPECT_EQ(seen_on(lab, 0), "the kernel refuses a datagram to UDP port 4717");
}

TEST_F(Silence, OfAStrictKernelWithTwoInterfacesInOneNetwork) {
  Lab lab(2);
  must_run(lab, 0, {ip, "link", "add", "eth1", "type", "veth", "peer", "name", "eth2"});
  must_run(lab, 0, {ip, "address", "add", "10.47.17.101/24", "dev", "eth1"});
  must_run(lab, 0, {ip, "link", "set", "eth1", "up"});
  must_run(lab, 0, {ip, "link", "set", "eth2", "up"});
  lab.start_all({"--interval", "0.2"});
  EXPECT_TRUE(comes_to(lab, 0, {}));
  set_kernel(lab, 0, "ipv4/conf/all/rp_filter", "1");
  EXPECT_TRUE(comes_to(lab, 0, {"rp_filter_strict"}));
}

TEST_F(Silence, OfASmallMtu) {
  Lab lab(2);
  must_run(lab, 0, {ip, "link", "set", "wlan0", "mtu", "1000"});
  lab.start_all({"--interval", "0.2"});
  EXPECT_TRUE(comes_to(lab, 0, {"mtu_small"}));
}

TEST_F(Silence, BetweenAHostOfIpv4AloneAndOneOfIpv6Alone) {
  Lab lab(2);
  set_kernel(lab, 0, "ipv6/conf/wlan0/disable_ipv6", "1");
  lab.take_ipv4(1);
  lab.start_all({"--interval", "0.2"});
  EXPECT_TRUE(comes_to(lab, 0, {"one_family"}));
  EXPECT_TRUE(comes_to(lab, 1, {"one_family"}));
}

TEST_F(Silence, OfHostsInDifferentNetworksOnOneLink) {
  Lab lab(2);
  must_run(lab, 1, {ip, "-4", "address", "flush", "dev", "wlan0"});
  must_run(lab, 1, {ip, "address", "add", "192.0.2.7/24", "dev", "wlan0"});
  lab.start_all({"--interval", "0.2"});
  EXPECT_TRUE(comes_to(lab, 0, {"off_link"}));
}

TEST_F(Silence, OnAnotherPortAndInAnotherGroup) {
  Lab lab(3);
  lab.start(0, {"--interval", "0.2"});
  lab.start(1, {"--interval", "0.2", "--port", "4800"});
  EXPECT_TRUE(comes_to(lab, 0, {"other_port"}));
  EXPECT_THAT(seen_on(lab, 0), HasSubstr("10.47.17.2 to port 4800 on wlan0"));
  lab.daemon(1).signal(SIGTERM);
  EXPECT_EQ(lab.daemon(1).wait(), 0);
  lab.start(2, {"--interval", "0.2", "--multicast", "239.192.47.18"});
  EXPECT_TRUE(comes_to(lab, 0, {"other_multicast"}));
  EXPECT_TRUE(comes_to(lab, 0, {"other_multicast"}, Rights::none));
  lab.daemon(2).signal(SIGTERM);
  EXPECT_EQ(lab.daemon(2).wait(), 0);
  lab.start(1, {"--interval", "0.2", "--port", "4718"});
  EXPECT_TRUE(comes_to(lab, 0, {"other_port"}, Rights::none));
}

TEST_F(Silence, OfAnInterfaceWithoutARouteForMulticasts) {
  Lab lab(2);
  lab.take_ipv4(0);
  lab.take_ipv4(1);
  lab.start_all({"--interval", "0.2"});
  EXPECT_TRUE(comes_to(lab, 0, {}));
  must_run(lab, 0, {ip, "-6", "route", "del", "multicast", "ff00::/8", "dev", "wlan0", "table", "local"});
  EXPECT_TRUE(comes_to(lab, 0, {"no_multicast_route"}));
}

TEST_F(Silence, OfAnInterfaceThatIsDown) {
  Lab lab(1);
  lab.start(0);
  lab.cut(0);
  EXPECT_TRUE(comes_to(lab, 0, {"no_interface"}));
}

TEST_F(Silence, OfASecondDaemonWithinTheHost) {
  Lab lab(1);
  lab.start(0, {"--interval", "0.2"});
  system::Process second(
      lab.on(0, {system::program("gemingad"), "--name", "second", "--interval", "0.2", "--gcnp", "127.0.0.1:4718"}));
  ASSERT_TRUE(second.wait_for(" ready: "));
  EXPECT_TRUE(comes_to(lab, 0, {"two_daemons"}));
}

TEST_F(Silence, OfKeysThatOthersMayReadAndThatHostsLack) {
  const Folder folder;
  const std::string key = key_file(folder, "team.key");
  Lab lab(3);
  lab.start(0, {"--interval", "0.2", "--key-file", key});
  lab.start(1, {"--interval", "0.2", "--key-file", key});
  ASSERT_TRUE(lab.wait_for_participants(0, 2));
  EXPECT_TRUE(comes_to(lab, 0, {}));
  ASSERT_EQ(::chmod(key.c_str(), 0644), 0);
  EXPECT_TRUE(comes_to(lab, 0, {"key_readable"}));
  ASSERT_EQ(::chmod(key.c_str(), 0600), 0);
  lab.start(2, {"--interval", "0.2"});
  EXPECT_TRUE(comes_to(lab, 0, {"unsealed_heard"}));
  EXPECT_TRUE(comes_to(lab, 2, {"key_missing"}));
}

TEST_F(Silence, OfKeysThatAreMixed) {
  const Folder folder;
  const std::string key = key_file(folder, "team.key");
  const std::string next = key_file(folder, "next.key");
  Lab lab(3);
  lab.start(0, {"--interval", "0.2", "--key-file", key, "--key-file", next});
  lab.start(1, {"--interval", "0.2", "--key-file", key});
  EXPECT_TRUE(comes_to(lab, 0, {"key_lacking"}));
  EXPECT_TRUE(comes_to(lab, 1, {}));
  lab.start(2, {"--interval", "0.2", "--key-file", key_file(folder, "other.key")});
  EXPECT_TRUE(comes_to(lab, 1, {"other_key"}));
}

TEST_F(Silence, OfTwoTeamsInOneGroup) {
  const Folder folder;
  const std::string zoo = folder.write("zoo.ttl", system::animals);
  Lab lab(4);
  for (const std::size_t host : {0U, 1U}) lab.start(host, {"--interval", "0.2", "--ontology", zoo});
  for (const std::size_t host : {2U, 3U})
    lab.start(host, {"--interval", "0.2", "--ontology", system::shipped("robot-soccer.ttl")});
  EXPECT_TRUE(comes_to(lab, 0, {"two_teams"}));
}

TEST_F(Silence, OfAnOntologyThatDoesNotKnowANameOfTheOther) {
  const Folder folder;
  Lab lab(2);
  lab.start(0, {"--interval", "0.2", "--ontology", system::shipped("robot-soccer.ttl")});
  lab.start(1, {"--interval", "0.2", "--ontology", folder.write("zoo.ttl", system::animals)});
  system::Talk talk = lab.talk(1);
  talk.say("1 pub create mode=oto concept=<http://zoo.example/#Cat> port=5000");
  EXPECT_THAT(talk.lines_until_pong(), testing::IsEmpty());
  EXPECT_TRUE(comes_to(lab, 0, {"ontologies_differ"}));
  EXPECT_THAT(seen_on(lab, 0), HasSubstr("<http://zoo.example/#Cat>"));
}

TEST_F(Silence, OfAnAddressThatCannotBeReached) {
  Lab lab(2);
  must_run(lab, 1, {ip, "address", "add", "192.0.2.7/24", "dev", "wlan0"});
  lab.start_all({"--interval", "0.2"});
  system::Talk talk = lab.talk(1);
  talk.say("1 pub create mode=oto id=77 port=5000 address=192.0.2.7");
  EXPECT_THAT(talk.lines_until_pong(), testing::IsEmpty());
  EXPECT_TRUE(comes_to(lab, 0, {"address_unreachable"}));
  EXPECT_TRUE(comes_to(lab, 1, {}));
}

TEST_F(Silence, OfAPublisherWithoutAPlaceForAnotherListener) {
  Lab lab(2);
  lab.start_all({"--interval", "0.2"});
  system::Talk talk = lab.talk(1);
  talk.say("1 pub create mode=otm/stream id=77 port=5000 channel.full=1024");
  EXPECT_THAT(talk.lines_until_pong(), testing::IsEmpty());
  EXPECT_TRUE(comes_to(lab, 0, {"listeners_full"}));
}

TEST_F(SilenceByFirewall, OfLossThatDeadlinesDoNotBear) {
  Lab lab(2);
  lab.start_all({"--interval", "0.1"});
  ASSERT_TRUE(lab.wait_for_participants(0, 2));
  EXPECT_TRUE(comes_to(lab, 0, {}));
  lab.lose(0.75);
  EXPECT_TRUE(comes_to(lab, 0, {"loss_high"}));
}

TEST_F(SilenceByFirewall, IsNotFoundInAHealthyTeamOfTenThatLosesThirtyPercent) {
  Lab lab(10);
  lab.lose(0.3);
  for (std::size_t host = 0; host < 10; ++host) lab.begin(host, {"--interval", "0.5"});
  for (std::size_t host = 0; host < 10; ++host) lab.wait_until_ready(host);
  for (std::size_t host = 0; host < 10; ++host) ASSERT_TRUE(lab.wait_for_participants(host, 10));
  for (std::size_t host = 0; host < 10; ++host)
    EXPECT_THAT(codes_in(examined(lab, host)), testing::IsEmpty()) << "host " << host;
}

}  // namespace
}  // namespace geminga::tools
