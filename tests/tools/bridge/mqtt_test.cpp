// geminga-bridge mqtt between daemons that have a real mosquitto and nothing else between them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "tools/bridge/lying_server.hpp"
#include "tools/bridge/server_link.hpp"

namespace geminga::system {
namespace {

constexpr const char* mosquitto = "/usr/sbin/mosquitto";

class Mqtt : public testing::Test {
 protected:
  void SetUp() override {
    if (::access(mosquitto, X_OK) != 0) GTEST_SKIP() << mosquitto << " is not installed";
    if (!link_.lab().has_namespaces()) GTEST_SKIP() << "no network namespaces can be made";
  }

  Folder folder_;
  std::string configuration_ = folder_.write("mosquitto.conf", "listener 1883 10.47.17.1\nallow_anonymous true\n");
  ServerLink link_{{mosquitto, "-c", configuration_}, "running", "mqtt", "mqtt://10.47.17.1"};
};

TEST_F(Mqtt, JoinsDaemonsThatHaveNothingElseBetweenThem) {
  link_.give_flags(1, {"--mqtt", "5"});
  expect_team_over(link_);
  EXPECT_TRUE(link_.bridge(0).wait_for("other sites on the server: 2"));
  link_.bridge(0).forget();
  link_.kill_bridge(1);
  EXPECT_TRUE(link_.bridge(0).wait_for("other sites on the server: 1")) << "the last will";
  link_.bridge(2).signal(SIGTERM);
  EXPECT_EQ(link_.bridge(2).wait(), 0);
  EXPECT_TRUE(link_.bridge(0).wait_for("other sites on the server: 0"));
}

TEST_F(Mqtt, TellsANewcomerOfASiteByWhatIsRetained) {
  link_.give_flags(0, {"--mqtt", "5"});
  expect_newcomer_over(link_);
}

TEST_F(Mqtt, CountsWhatALyingServerSays) {
  link_.start_server();
  link_.start_bridge(0);
  const auto publish = [&](const std::string& topic, const std::vector<std::string>& words) {
    std::vector<std::string> line{"/usr/bin/mosquitto_pub", "-h", "10.47.17.1", "-t", topic};
    line.insert(line.end(), words.begin(), words.end());
    return run(link_.lab().on(1, line)).status;
  };
  if (::access("/usr/bin/mosquitto_pub", X_OK) != 0) GTEST_SKIP() << "mosquitto_pub is not installed";
  EXPECT_EQ(publish("geminga/geminga/word/liar", {"-m", std::string(1473, 'x')}), 0);
  EXPECT_TRUE(link_.bridge(0).wait_for("1 words of no size that a word has")) << link_.bridge(0).said();
  EXPECT_EQ(publish("geminga/geminga/word/liar", {"-r", "-m", "kept"}), 0);
  link_.kill_bridge(0);
  link_.start_bridge(0);
  EXPECT_TRUE(link_.bridge(0).wait_for("1 words that the server had kept")) << "nobody is told what may be old";
}

/// A packet of MQTT: its first octet, the length of what follows (MQTT 3.1.1, section 2.2.3), and that.
std::string packet(int first, const std::string& rest) {
  std::string octets(1, static_cast<char>(first));
  std::size_t size = rest.size();
  do {
    octets += static_cast<char>(size % 128 + (size >= 128 ? 128 : 0));
    size /= 128;
  } while (size > 0);
  return octets + rest;
}

/// A message with QoS 0 under a topic.
std::string message(const std::string& topic, const std::string& payload) {
  const auto size = static_cast<unsigned>(topic.size());
  return packet(0x30, std::string{static_cast<char>(size >> 8U), static_cast<char>(size & 0xffU)} + topic + payload);
}

/// The bridge of a server on this host, without a daemon behind it; its UDP port has the number of the server's.
Process::Start bridge_to(const LyingServer& liar, const std::string& version) {
  return {
      .words = {program("geminga-bridge-mqtt"), "mqtt://" + liar.where(), "--listen", liar.where(), "--mqtt", version},
      .environment = {},
      .before = {}};
}

void expect_end(Process& bridge) {
  bridge.signal(SIGTERM);
  EXPECT_EQ(bridge.wait(), 0) << bridge.said();
}

TEST(MqttLiar, IsNoServerWhereItSpeaksSomethingElse) {
  const std::string refusal = packet(0x20, std::string{0, 1});  // "unacceptable protocol version", as by MQTT 3.1.1
  for (const std::string& greeting :
       {std::string("SSH-2.0-OpenSSH_9.2\r\n"), std::string("\xff\xff\xff\xff\xff\xff"), packet(0x20, "")}) {
    const LyingServer liar(greeting, "", "");
    Process bridge(bridge_to(liar, "5"));
    EXPECT_TRUE(bridge.wait_for("no words from " + liar.where())) << greeting << bridge.said();
    expect_end(bridge);
  }
  const LyingServer old(refusal, "MQTT", "");
  Process bridge(bridge_to(old, "3.1.1"));
  EXPECT_TRUE(bridge.wait_for("the server does not take us: ")) << bridge.said();
  expect_end(bridge);
}

TEST(MqttLiar, IsCountedWhereItFloodsAndSaysWhatNobodyAskedFor) {
  std::string answer = packet(0x20, std::string{0, 0});
  answer += message("geminga/geminga/word/x", std::string(1473, 'x'));
  answer += message("geminga/geminga/other", "ball") + message("/", "") + message("geminga/geminga/kept", "ball");
  answer += message("geminga/geminga/kept/", "ball") + message("geminga/geminga/kept/x/y/z", std::string(5000, 'x'));
  for (int site = 0; site < 2000; ++site) answer += message("geminga/geminga/site/" + std::to_string(site), "there");
  std::string flood;  // without an end: how many words a busy machine reads in a second is not known
  for (int word = 0; word < 1000; ++word) flood += message("geminga/geminga/word/x", "ball");
  const LyingServer liar("", "MQTT", answer, flood);
  Process bridge(bridge_to(liar, "3.1.1"));
  EXPECT_TRUE(bridge.wait_for("carrying words by " + liar.where())) << bridge.said();
  EXPECT_TRUE(bridge.wait_for("messages that nobody has asked for")) << bridge.said();
  EXPECT_TRUE(bridge.wait_for("words of no size that a word has")) << bridge.said();
  EXPECT_TRUE(bridge.wait_for("words over the limit of a second")) << bridge.said();
  expect_end(bridge);
}

TEST(MqttLiar, IsLeftWhereATopicIsNoUtf8) {
  const LyingServer liar("", "MQTT",
                         packet(0x20, std::string{0, 0}) + message("geminga/geminga/word/\xff\xfe", "ball"));
  Process bridge(bridge_to(liar, "3.1.1"));
  EXPECT_TRUE(bridge.wait_for("no words from " + liar.where())) << bridge.said();
  expect_end(bridge);
}

}  // namespace
}  // namespace geminga::system
