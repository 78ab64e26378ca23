// geminga-bridge mqtt between daemons that have a real mosquitto and nothing else between them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <string>

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

}  // namespace
}  // namespace geminga::system
