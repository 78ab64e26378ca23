// Real daemons with keys: which ones hear each other, a rotation by SIGHUP, and the output of the tools.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>

#include "support/lab.hpp"
#include "system/folder.hpp"
#include "system/stranger.hpp"

namespace geminga::system {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Makes a key file by gemingad. Returns the key's id.
std::string make_key(const std::string& path) {
  const Ran made = refused({"--generate-key", path});
  EXPECT_EQ(made.status, 0) << made.said;
  const std::string word = path + ": key ";
  const auto at = made.said.find(word);
  return at == std::string::npos ? "" : made.said.substr(at + word.size(), 4);
}

TEST(Sealed, DaemonsOfOneKeyMeetAndHearNobodyWithoutIt) {
  const Folder folder;
  const std::string key = make_key(folder.path("team.key"));
  Lab lab(4);
  lab.start(0, {"--interval", "0.1", "--key-file", folder.path("team.key")});
  lab.start(1, {"--interval", "0.1", "--key-file", folder.path("team.key"), "--sealing", "authenticated"});
  EXPECT_NE(make_key(folder.path("other.key")), "");
  lab.start(2, {"--interval", "0.1", "--key-file", folder.path("other.key")});
  lab.start(3, {"--interval", "0.1"});
  EXPECT_TRUE(lab.wait_for_participants(0, 2)) << lab.way();
  EXPECT_TRUE(lab.wait_for_participants(1, 2));
  Talk talk = lab.talk(0);
  EXPECT_TRUE(talk.wait_until("security", [&](const auto& lines) {
    return testing::Matches(
        AllOf(Contains(HasSubstr("mode=encrypted keys=" + key)),
              Contains(HasSubstr("protection=authenticated key=" + key + " ")),
              Contains(AllOf(HasSubstr("source="), HasSubstr("rejected=unknown-key"), HasSubstr("count="))),
              Contains(AllOf(HasSubstr("source="), HasSubstr("protection=plain rejected=plain")))))(lines);
  })) << testing::PrintToString(talk.query("security"));
  EXPECT_TRUE(lab.wait_for_participants(2, 1));
  EXPECT_TRUE(lab.wait_for_participants(3, 1));
  EXPECT_TRUE(lab.daemon(0).wait_for("sealed with a key that is not among ours")) << lab.daemon(0).said();
}

TEST(Sealed, DaemonsRotateTheirKeyWithoutLosingAService) {
  const Folder folder;
  const std::string first = make_key(folder.path("first.key"));
  const std::string second = make_key(folder.path("second.key"));
  const std::string file = folder.write("geminga.toml", "key-file = [\"first.key\"]\ninterval = 0.1\n");
  Lab lab(3);
  lab.start_all({"--config", file});
  for (const std::size_t host : {0U, 1U, 2U}) ASSERT_TRUE(lab.wait_for_participants(host, 3)) << lab.way();
  Talk consumer = lab.talk(1);
  consumer.say("1 sub create mode=otm/stream id=5");
  Talk provider = lab.talk(0);
  provider.say("1 pub create mode=otm/stream id=5 port=5000");
  ASSERT_TRUE(consumer.line_with({"1 pub add"}));
  for (const auto& [keys, seals] : {std::pair{"\"first.key\", \"second.key\"", first},
                                    {"\"second.key\", \"first.key\"", second},
                                    {"\"second.key\"", second}}) {
    (void)folder.write("geminga.toml", "key-file = [" + std::string(keys) + "]\ninterval = 0.1\n");
    for (const std::size_t host : {0U, 1U, 2U}) {
      lab.daemon(host).forget();
      lab.daemon(host).signal(SIGHUP);
      EXPECT_TRUE(lab.daemon(host).wait_for("announcements: encrypted, keys " + seals)) << lab.daemon(host).said();
    }
    EXPECT_TRUE(consumer.wait_until("security", [&, seal = seals](const auto& lines) {
      int sealing = 0;
      for (const std::string& line : lines) {
        if (line.contains(" participant=") && field(line, "key") == seal && field(line, "lacks").empty()) ++sealing;
      }
      return sealing == 2;
    })) << testing::PrintToString(consumer.query("security"));
  }
  EXPECT_THAT(consumer.lines_until_pong(), Not(Contains(HasSubstr("pub del"))));
  // A key that cannot be read changes nothing.
  ASSERT_EQ(::chmod(folder.path("second.key").c_str(), 0644), 0);
  lab.daemon(0).signal(SIGHUP);
  EXPECT_TRUE(lab.daemon(0).wait_for("chmod 600")) << lab.daemon(0).said();
  EXPECT_TRUE(lab.wait_for_participants(0, 3));
}

TEST(Sealed, ADaemonThatLosesItsKeyFileStaysSealedUntilPlainIsSaid) {
  const Folder folder;
  const std::string key = make_key(folder.path("team.key"));
  const std::string file = folder.write("geminga.toml", "key-file = \"team.key\"\ninterval = 0.1\n");
  Lab lab(2);
  lab.start_all({"--config", file});
  ASSERT_TRUE(lab.wait_for_participants(0, 2)) << lab.way();
  (void)folder.write("geminga.toml", "interval = 0.1\n");
  lab.daemon(0).forget();
  lab.daemon(0).signal(SIGHUP);
  EXPECT_TRUE(lab.daemon(0).wait_for("key-file: no key is named any more")) << lab.daemon(0).said();
  EXPECT_TRUE(lab.daemon(0).wait_for("the configuration in force is kept"));
  Talk talk = lab.talk(0);
  EXPECT_THAT(talk.query("security"), Contains(HasSubstr("mode=encrypted keys=" + key)));
  EXPECT_THAT(talk.query("status"), Contains(HasSubstr("configuration_failed=")));
  EXPECT_TRUE(lab.wait_for_participants(0, 2));
  (void)folder.write("geminga.toml", "interval = 0.1\nsealing = \"plain\"\n");
  lab.daemon(0).forget();
  lab.daemon(0).signal(SIGHUP);
  EXPECT_TRUE(lab.daemon(0).wait_for("announcements are not sealed")) << lab.daemon(0).said();
  EXPECT_TRUE(lab.wait_for_participants(0, 1)) << "the other one is sealed still";
}

TEST(Sealed, DaemonsAreNotToldTwiceByWhoRepeatsThem) {
  const Folder folder;
  (void)make_key(folder.path("team.key"));
  Lab lab(3);
  const std::vector<std::string> flags{"--interval", "0.1", "--key-file", folder.path("team.key")};
  lab.start(0, flags);
  lab.start(1, flags);
  ASSERT_TRUE(lab.wait_for_participants(0, 2)) << lab.way();
  const Stranger stranger(lab, 2);
  for (int repeated = 0, silent = 0; repeated < 20 && silent < 1000; ++silent) {
    const auto datagram = stranger.hear();
    if (!datagram) continue;
    EXPECT_FALSE(datagram->contains("robot"));
    ASSERT_TRUE(stranger.send(*datagram));
    ++repeated;
    silent = 0;
  }
  Talk talk = lab.talk(0);
  EXPECT_TRUE(talk.wait_until("status", [](const auto& lines) {
    return !lines.empty() && !field(lines[0], "sealing_replayed").empty();
  })) << testing::PrintToString(talk.query("status"));
  EXPECT_THAT(talk.query("status"), Not(Contains(HasSubstr("contradicted="))));
}

TEST(Sealed, DaemonsRefuseAKeyThatOthersCanRead) {
  const Folder folder;
  const std::string key = folder.path("team.key");
  (void)make_key(key);
  const Ran again = refused({"--generate-key", key});
  EXPECT_EQ(again.status, 2);
  EXPECT_THAT(again.said, HasSubstr("gemingad: " + key + ": is there already, and a key is never overwritten"));
  ASSERT_EQ(::chmod(key.c_str(), 0640), 0);
  for (const char* flag : {"--check-config", "--log-level=info"}) {
    const Ran ran = refused({"--key-file", key, flag});
    EXPECT_EQ(ran.status, 2);
    EXPECT_THAT(ran.said, HasSubstr("gemingad: " + key + ": its group or others may read or change it"));
  }
  ASSERT_EQ(::chmod(key.c_str(), 0600), 0);
  const Ran good = refused({"--check-config"}, {{"GEMINGA_KEY_FILE", key}, {"GEMINGA_SEALING", "mixed"}});
  EXPECT_EQ(good.status, 0);
  EXPECT_THAT(good.said, AllOf(HasSubstr("key-file = [\"" + key + "\"]\n"), HasSubstr("sealing = \"mixed\"\n")));
}

/// Two daemons without common multicast: their groups and ports differ.
std::vector<std::string> apart(const Lab& lab, std::size_t host, const Folder& folder) {
  return {"--interval",  "0.1",
          "--key-file",  folder.path("team.key"),
          "--port",      std::to_string(lab.udp_port() + 1 + static_cast<int>(host)),
          "--multicast", "239.192.47.2" + std::to_string(host)};
}

TEST(Sealed, OneSideThatNamesTheOtherIsEnoughWhereMulticastDoesNotPass) {
  const Folder folder;
  make_key(folder.path("team.key"));
  make_key(folder.path("other.key"));
  Lab lab(3);
  auto base = apart(lab, 0, folder);
  base.insert(base.end(), {"--peer", "*"});
  lab.start(0, base);
  const std::string at = lab.address_of(0) + ':' + std::to_string(lab.udp_port() + 1);
  auto robot = apart(lab, 1, folder);
  robot.insert(robot.end(), {"--peer", at});
  lab.start(1, robot);
  lab.start(2, {"--interval", "0.1", "--key-file", folder.path("other.key"), "--port",
                std::to_string(lab.udp_port() + 3), "--multicast", "239.192.47.22", "--peer", at});
  for (const std::size_t host : {0U, 1U}) ASSERT_TRUE(lab.wait_for_participants(host, 2)) << lab.way();
  Talk consumer = lab.talk(1);
  consumer.say("1 sub create mode=otm/stream id=5");
  Talk provider = lab.talk(0);
  provider.say("1 pub create mode=otm/stream id=5 port=5000");
  EXPECT_TRUE(consumer.line_with({"1 pub add"}));
  const auto status = provider.query("status");
  ASSERT_EQ(status.size(), 1U);
  EXPECT_EQ(field(status[0], "peers_unnamed"), "1") << status[0];
  EXPECT_TRUE(lab.wait_for_participants(2, 1)) << "who has another key is nobody's guest";
}

TEST(Sealed, APeerThatMovesIsHeardFromWhereItIsNow) {
  const Folder folder;
  make_key(folder.path("team.key"));
  Lab lab(2);
  if (!lab.has_namespaces()) GTEST_SKIP() << "the loopback interface keeps its address";
  for (const std::size_t host : {0U, 1U}) {
    auto flags = apart(lab, host, folder);
    const std::size_t other = 1 - host;
    flags.insert(flags.end(),
                 {"--peer", lab.address_of(other) + ':' + std::to_string(lab.udp_port() + 1 + int(other))});
    lab.start(host, flags);
  }
  for (const std::size_t host : {0U, 1U}) ASSERT_TRUE(lab.wait_for_participants(host, 2)) << lab.way();
  Talk consumer = lab.talk(0);
  consumer.say("1 sub create mode=otm/stream id=5");
  Talk provider = lab.talk(1);
  provider.say("1 pub create mode=otm/stream id=5 port=5000");
  ASSERT_TRUE(consumer.line_with({"1 pub add"}));
  for (const auto& words : {std::vector<std::string>{"flush", "dev", "wlan0"},
                            std::vector<std::string>{"add", "10.47.17.99/24", "dev", "wlan0"}}) {
    std::vector<std::string> line{"/bin/ip", "-4", "address"};
    line.insert(line.end(), words.begin(), words.end());
    ASSERT_EQ(run(lab.on(1, line)).status, 0);
  }
  const auto moved = consumer.line_with({"1 pub modify", "address=10.47.17.99"});
  EXPECT_TRUE(moved) << "though nobody has named it there";
  EXPECT_TRUE(lab.wait_for_participants(1, 2));
}

}  // namespace
}  // namespace geminga::system
