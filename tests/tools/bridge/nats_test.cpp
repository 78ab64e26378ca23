// geminga-bridge nats between daemons that have a real nats-server and nothing else between them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <deque>
#include <memory>
#include <string>

#include "tools/bridge/lying_server.hpp"
#include "tools/bridge/server_link.hpp"

namespace geminga::system {
namespace {

constexpr const char* server = "/usr/sbin/nats-server";

class Nats : public testing::Test {
 protected:
  void SetUp() override {
    if (::access(server, X_OK) != 0) GTEST_SKIP() << server << " is not installed";
    if (!link_.lab().has_namespaces()) GTEST_SKIP() << "no network namespaces can be made";
  }

  Folder folder_;
  ServerLink link_{
      {server, "-a", "10.47.17.1", "-js", "-sd", folder_.path("js")}, "Server is ready", "nats", "nats://10.47.17.1"};
};

TEST_F(Nats, JoinsDaemonsThatHaveNothingElseBetweenThem) {
  expect_team_over(link_);
  link_.bridge(2).signal(SIGTERM);
  EXPECT_EQ(link_.bridge(2).wait(), 0);
  EXPECT_TRUE(link_.lab().wait_for_participants(0, 1));
}

TEST_F(Nats, JoinsASiteThroughItsRelay) { expect_site_over(link_); }

TEST_F(Nats, TellsANewcomerOfASiteByWhatItHasKept) { expect_newcomer_over(link_); }

TEST_F(Nats, KeepsASiteThatHasTwoRelaysAndLosesOne) { expect_standby_over(link_); }

TEST_F(Nats, StandsBesideMqttAtOneDaemonAndEitherIsEnough) {
  constexpr const char* broker = "/usr/sbin/mosquitto";
  const std::string other_kind = program("geminga-bridge-mqtt");
  if (::access(broker, X_OK) != 0 || ::access(other_kind.c_str(), X_OK) != 0) GTEST_SKIP() << "there is no MQTT";
  link_.start_server();
  link_.make_key();
  const std::string file = folder_.write("mosquitto.conf", "listener 1883 10.47.17.1\nallow_anonymous true\n");
  auto mqtt = std::make_unique<Process>(link_.lab().on(0, {broker, "-c", file}));
  ASSERT_TRUE(mqtt->wait_for("running")) << mqtt->said();
  std::deque<Process> others;
  for (const std::size_t host : {1U, 2U}) {
    link_.start_bridge(host);
    Process& other =
        others.emplace_back(link_.lab().on(host, {other_kind, "mqtt://10.47.17.1", "--listen", "127.0.0.1:4721"}));
    EXPECT_TRUE(other.wait_for("carrying words")) << other.said();
    link_.start_between_two(host);
  }
  for (const std::size_t host : {1U, 2U}) EXPECT_TRUE(link_.lab().wait_for_participants(host, 2)) << host;
  Talk consumer = link_.lab().talk(2);
  consumer.say("7 sub create mode=otm/stream text=ball");
  Talk provider = link_.lab().talk(1);
  // Until each hears the other on both links a word may come back, or come twice.
  const auto gone_round = [this] {
    return link_.status(1, "relay_own") + link_.status(1, "relay_repeated") + link_.status(2, "sealing_replayed");
  };
  bool goes_round = true;
  for (int round = 0; goes_round && round < 20; ++round) {
    const std::size_t before = gone_round();
    for (const char* port : {"5000", "5001", "5002"}) {
      provider.say(std::string("4 pub create mode=otm/stream text=ball port=") + port);
      ASSERT_TRUE(consumer.line_with({"7 pub add", std::string("port=") + port}));
      provider.say("4 pub remove");
      ASSERT_TRUE(consumer.line_with({"7 pub del", "reason=withdrawn"}));
    }
    goes_round = gone_round() > before;
  }
  EXPECT_FALSE(goes_round) << "both hear each other on both links";

  provider.say("4 pub create mode=otm/stream text=ball port=5003");
  EXPECT_TRUE(consumer.line_with({"7 pub add", "port=5003"}));
  link_.bridge(1).forget();
  link_.bridge(2).forget();
  link_.kill_server();
  provider.say("5 pub create mode=otm/stream text=ball port=5004");
  const auto next = consumer.line_with({"7 pub "});
  ASSERT_TRUE(next);
  EXPECT_EQ(field(*next, "port"), "5004") << "MQTT alone is enough, and nothing was lost";
  link_.start_server();
  for (const std::size_t host : {1U, 2U}) EXPECT_TRUE(link_.bridge(host).wait_for("carrying words by")) << host;
  mqtt.reset();
  provider.say("6 pub create mode=otm/stream text=ball port=5005");
  EXPECT_TRUE(consumer.line_with({"7 pub add", "port=5005"})) << "and so is NATS";
}

TEST_F(Nats, CarriesWordsToALeafNodeWhoseSiteReadsWhatTheHubKeeps) {
  constexpr std::size_t crowd = 10;
  const std::string hub =
      folder_.write("hub.conf", "listen: \"10.47.17.1:4222\"\njetstream { store_dir: \"" + folder_.path("js") +
                                    "\", domain: hub }\nleafnodes { listen: \"10.47.17.1:7422\" }\n");
  const std::string leaf = folder_.write("leaf.conf",
                                         "listen: \"127.0.0.1:4222\"\n"
                                         "leafnodes { remotes: [ { url: \"nats-leaf://10.47.17.1:7422\" } ] }\n");
  ServerLink link({server, "-c", hub}, "Server is ready", "nats", "nats://10.47.17.1");
  link.start_server();
  link.make_key();
  link.start_crowd(crowd);
  EXPECT_TRUE(link.wait_until_kept(0, crowd + 1));
  Process leaf_server(link.lab().on(2, {server, "-c", leaf}));
  EXPECT_TRUE(leaf_server.wait_for("Leafnode connection created")) << leaf_server.said();
  Process bridge(link.lab().on(2, {program("geminga-bridge-nats"), "nats://127.0.0.1", "--jetstream-domain", "hub"}));
  EXPECT_TRUE(bridge.wait_for("words are kept in the bucket geminga_geminga")) << bridge.said();
  link.start_daemon(2);
  EXPECT_TRUE(link.lab().wait_for_participants(2, crowd + 3)) << bridge.said();
  EXPECT_EQ(link.status(2, "recalled"), crowd + 1);
}

TEST_F(Nats, IsAUserByNKeyOverTlsAndSaysWhyItIsRefused) {
  Folder folder;
  const std::string certificate = folder.path("server.pem");
  const Ran made =
      run({.words = {"/usr/bin/openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1",
                     "-nodes", "-keyout", folder.path("server.key"), "-out", certificate, "-subj", "/CN=server",
                     "-addext", "subjectAltName=IP:10.47.17.1"},
           .environment = {},
           .before = {}});
  if (made.status != 0) GTEST_SKIP() << "openssl makes no certificate: " << made.said;
  // The pair of keys of NATS' documentation.
  const std::string user = "UDXU4RCSJNZOIQHZNWXHXORDPRTGNJAHAHFRGZNEEJCPQTT2M7NLCNF4";
  const std::string seed = folder.write("user.nk", "SUACSSL3UAHUDXKFSNVUZRF5UHPMWZ6BFDTJ7M6USDXIEDNPPQYYYCU3VY\n");
  const std::string configuration = folder.write(
      "nats.conf", "listen: \"10.47.17.1:4222\"\ntls { cert_file: \"" + certificate + "\", key_file: \"" +
                       folder.path("server.key") + "\" }\naccounts { team { users: [ { nkey: " + user + " } ] } }\n");
  ServerLink link({server, "-c", configuration}, "Server is ready", "nats", "tls://10.47.17.1");
  link.start_server();
  link.give_flags(0, {"--ca", certificate});
  link.begin_bridge(0);
  EXPECT_TRUE(link.bridge(0).wait_for("Authorization Violation")) << link.bridge(0).said();
  link.begin_bridge(1);
  EXPECT_TRUE(link.bridge(1).wait_for("SSL handshake error")) << link.bridge(1).said();
  link.give_flags(2, {"--ca", certificate, "--nkey", user, "--nkey-seed", seed});
  link.start_bridge(2);
}

/// The bridge of a server on this host, without a daemon behind it; its UDP port has the number of the server's.
Process::Start bridge_to(const LyingServer& liar) {
  return {.words = {program("geminga-bridge-nats"), "nats://" + liar.where(), "--listen", liar.where()},
          .environment = {},
          .before = {}};
}

TEST(NatsLiar, IsNoServerWhereItSpeaksSomethingElse) {
  for (const std::string greeting : {"SSH-2.0-OpenSSH_9.2\r\n", "INFO {\"max_payload\":\r\n", "\xff\xfe\r\n"}) {
    const LyingServer liar(greeting, "", "");
    Process bridge(bridge_to(liar));
    EXPECT_TRUE(bridge.wait_for("no words from " + liar.where())) << greeting << bridge.said();
    bridge.signal(SIGTERM);
    EXPECT_EQ(bridge.wait(), 0) << greeting << bridge.said();
  }
}

TEST(NatsLiar, IsCountedWhereItFloodsAndSaysWhatNoWordIs) {
  // The answer to the first PING, then words by a subject that is no UTF-8: one too long, and more than a second takes,
  // without an end: how many a busy machine reads in a second is not known.
  const std::string answer = "PONG\r\nMSG geminga.geminga.word.\xff\xfe 1 1473\r\n" + std::string(1473, 'x') + "\r\n";
  std::string flood;
  for (int word = 0; word < 1000; ++word) flood += "MSG geminga.geminga.word.\xff\xfe 1 4\r\nball\r\n";
  const LyingServer liar(R"(INFO {"server_id":"L","version":"99.0.0","proto":1,"max_payload":1048576,"headers":true})"
                         "\r\n",
                         "PING\r\n", answer, flood);
  Process bridge(bridge_to(liar));
  EXPECT_TRUE(bridge.wait_for("carrying words by " + liar.where())) << bridge.said();
  EXPECT_TRUE(bridge.wait_for("words of no size that a word has")) << bridge.said();
  EXPECT_TRUE(bridge.wait_for("words over the limit of a second")) << bridge.said();
  bridge.signal(SIGTERM);
  EXPECT_EQ(bridge.wait(), 0) << bridge.said();
}

}  // namespace
}  // namespace geminga::system
