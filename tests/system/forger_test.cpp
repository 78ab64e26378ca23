// Real daemons beside a forger on the link who sends in their names; dropped datagrams are counted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "base/text.hpp"
#include "discovery/announcement/codec.hpp"
#include "support/lab.hpp"
#include "system/stranger.hpp"

namespace geminga::system {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

announcement::Announcement read(const std::string& bytes) {
  return announcement::decode(std::as_bytes(std::span(bytes))).value_or(announcement::Announcement{});
}

std::string written(const announcement::Announcement& announcement) {
  const auto datagrams = announcement::encode(announcement);
  return {reinterpret_cast<const char*>(datagrams.front().data()), datagrams.front().size()};
}

long counted(const std::vector<std::string>& lines, const std::string& key) {
  return lines.empty() ? 0 : base::parse_number<long>(field(lines[0], key)).value_or(0);
}

/// Answers each datagram of the daemon with this name by a state under its identifier, until `count` have been sent.
void contest(const Stranger& stranger, const std::string& name, int count) {
  for (int sent = 0, silent = 0; sent < count && silent < 1000; ++silent) {
    const auto datagram = stranger.hear();
    if (!datagram) continue;
    const auto heard = read(*datagram);
    if (heard.name != name || heard.kind == announcement::Kind::goodbye) continue;
    announcement::Announcement lie;
    lie.group = heard.group;
    lie.participant = heard.participant;
    lie.boot = announcement::BootNonce(99);
    lie.interval = heard.interval;
    lie.name = "liar";
    ASSERT_TRUE(stranger.send(written(lie)));
    ++sent;
    silent = 0;
  }
}

TEST(Forger, ThatClashesWithEveryDatagramOfADaemonDoesNotEndItNorStopItFromServing) {
  Lab lab(2);
  lab.start(0, {"--interval", "0.1"});
  Talk provider = lab.talk(0);
  Talk consumer = lab.talk(0);
  provider.say("1 pub create mode=otm/stream text=ball port=5000");
  consumer.say("1 sub create mode=otm/stream text=ball");
  ASSERT_TRUE(consumer.line_with({"1 pub add"}));
  const Stranger stranger(lab, 1);
  contest(stranger, "robot0", 60);
  EXPECT_THAT(consumer.query("services"), SizeIs(1));
  const auto status = consumer.query("status");
  EXPECT_GE(counted(status, "contested"), 40) << lab.daemon(0).said();
  EXPECT_GE(counted(status, "redraws"), 1);
  EXPECT_LE(counted(status, "redraws"), 6);
  EXPECT_THAT(status.at(0), HasSubstr("contested_from=\"" + lab.address_of(1) + " on "));
  EXPECT_TRUE(lab.daemon(0).wait_for("announces in our name")) << lab.daemon(0).said();
  EXPECT_TRUE(lab.daemon(0).wait_for("find that host, or keep it off this network"));
  lab.start(1, {"--interval", "0.1"});
  EXPECT_TRUE(lab.wait_for_participants(1, 2)) << "others find it";
}

TEST(Forger, ThatSaysGoodbyeInADaemonsNameIsContradictedAtOnce) {
  Lab lab(2);
  lab.start(0, {"--interval", "60"});
  const Stranger stranger(lab, 1);
  Talk talk = lab.talk(0);
  talk.say("1 pub create mode=otm/stream text=ball port=5000");
  announcement::Announcement last;
  // Until the change and its copies have been sent; a busy daemon takes its time.
  for (int silent = 0; silent < (last.peers.empty() ? 10'000 : 100);) {
    const auto datagram = stranger.hear();
    if (datagram && read(*datagram).kind == announcement::Kind::state) last = read(*datagram);
    silent = datagram ? 0 : silent + 1;
  }
  ASSERT_EQ(last.peers.size(), 1U);
  announcement::Announcement lie;
  lie.kind = announcement::Kind::goodbye;
  lie.group = last.group;
  lie.participant = last.participant;
  lie.boot = last.boot;
  ASSERT_TRUE(stranger.send(written(lie)));
  std::optional<std::string> answer;
  for (int silent = 0; silent < 1000 && !answer; ++silent) answer = stranger.hear();
  ASSERT_TRUE(answer);
  EXPECT_EQ(read(*answer).kind, announcement::Kind::state);
  EXPECT_EQ(read(*answer).revision, last.revision);
  EXPECT_GT(read(*answer).sequence, last.sequence);
  EXPECT_EQ(counted(talk.query("status"), "contradicted"), 1);
}

void ip(const std::string& words) {
  std::vector<std::string> all{"/bin/ip"};
  std::istringstream stream(words);
  for (std::string word; stream >> word;) all.push_back(word);
  const Ran ran = run({.words = all, .environment = {}, .before = {}});
  ASSERT_EQ(ran.status, 0) << words << ": " << ran.said;
}

TEST(Dropped, DatagramsFromOffTheLinkFromNoPeerAndFromWhereAPeerCannotBeAreCounted) {
  Lab lab(2);
  const auto has = [](const char* key) {
    return [key](const std::vector<std::string>& lines) { return counted(lines, key) == 1; };
  };
  if (!lab.has_namespaces()) {  // on the loopback interface every host is on the link
    lab.start(0, {"--peer", "127.0.0.9"});
    const Stranger stranger(lab, 0, "127.0.0.2");
    ASSERT_TRUE(stranger.send_to("127.0.0.1", lab.udp_port(), "from no peer"));
    EXPECT_TRUE(lab.talk(0).wait_until("status", has("dropped_no_peer")));
    return;
  }
  // The peer 192.0.2.5 is on the robot's second network; the stranger on the first one has that address, too.
  lab.visit(0, [] {
    ip("link add eth9 type veth peer name far9");
    ip("address add 192.0.2.1/24 dev eth9");
    ip("link set far9 up");
    ip("link set eth9 up");
    // The kernel does not check source addresses, as on many hosts.
    for (const char* interface : {"all", "wlan0", "eth9"})
      std::ofstream("/proc/sys/net/ipv4/conf/" + std::string(interface) + "/rp_filter") << "0";
  });
  lab.visit(1, [] { ip("address add 192.0.2.5/32 dev wlan0"); });
  lab.start(0, {"--peer", "192.0.2.5"});
  Talk talk = lab.talk(0);
  const Stranger stranger(lab, 1, "192.0.2.5");
  ASSERT_TRUE(stranger.send("from off the link"));
  EXPECT_TRUE(talk.wait_until("status", has("dropped_off_link"))) << lab.daemon(0).said();
  ASSERT_TRUE(stranger.send_to(lab.address_of(0), lab.udp_port(), "from where that peer cannot be"));
  EXPECT_TRUE(talk.wait_until("status", has("dropped_wrong_way"))) << lab.daemon(0).said();
  const Stranger neighbour(lab, 1);
  ASSERT_TRUE(neighbour.send_to(lab.address_of(0), lab.udp_port(), "from no peer"));
  EXPECT_TRUE(talk.wait_until("status", has("dropped_no_peer"))) << lab.daemon(0).said();
}

}  // namespace
}  // namespace geminga::system
