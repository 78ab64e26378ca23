// Local programs that flood or speak another protocol, and the Unix socket that keeps other users out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "support/lab.hpp"

namespace geminga::system {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

/// A daemon that listens at a path only.
class UnixSocket : public testing::Test {
 protected:
  UnixSocket() {
    std::string pattern = fs::temp_directory_path() / "geminga-socket-XXXXXX";
    if (::mkdtemp(pattern.data()) != nullptr) folder = pattern;
    path = folder + "/gcnp";
    flags = {"--gcnp", "none", "--gcnp-socket", path};
  }
  void SetUp() override {
    if (!lab.has_namespaces()) GTEST_SKIP() << "hosts of this lab are told apart by their TCP port";
    lab.start(0, flags);
  }
  ~UnixSocket() override { fs::remove_all(folder); }

  std::string folder;
  std::string path;
  Lab lab{1};
  std::vector<std::string> flags;
};

TEST_F(UnixSocket, ServesWhereTcpIsOffAndShowsWhoConnected) {
  struct stat made{};
  ASSERT_EQ(::lstat(path.c_str(), &made), 0);
  EXPECT_EQ(made.st_mode & 0777U, 0660U);
  EXPECT_THROW((void)lab.talk(0), std::runtime_error) << "TCP is off";
  Talk consumer = lab.talk(0, path);
  Talk provider = lab.talk(0, path);
  consumer.say("1 sub create mode=oto text=x");
  provider.say("1 pub create mode=oto text=x port=5000");
  EXPECT_TRUE(consumer.line_with({"1 pub add", "port=5000"}));
  EXPECT_THAT(consumer.query("peers"), AllOf(SizeIs(2), testing::Each(HasSubstr(" user="))));
  lab.daemon(0).signal(SIGTERM);
  EXPECT_EQ(lab.daemon(0).wait(), 0);
  EXPECT_FALSE(fs::exists(path)) << "removed at the end";
}

TEST_F(UnixSocket, OfAKilledDaemonIsReplacedAndThatOfALivingOneIsNot) {
  std::vector<std::string> words{program("gemingad"), "--interface", "lo"};
  words.insert(words.end(), flags.begin(), flags.end());
  const Ran second = run(lab.on(0, words));
  EXPECT_EQ(second.status, 2);
  EXPECT_THAT(second.said, HasSubstr(path + " is already in use"));
  EXPECT_THAT(lab.talk(0, path).lines_until_pong(), IsEmpty());
  lab.daemon(0).signal(SIGKILL);
  (void)lab.daemon(0).wait();
  ASSERT_TRUE(fs::exists(path));
  lab.start(0, flags);
  EXPECT_THAT(lab.talk(0, path).lines_until_pong(), IsEmpty());
}

TEST_F(UnixSocket, IsNeverPutInThePlaceOfAFile) {
  const std::string file = folder + "/precious";
  std::ofstream(file) << "precious";
  const Ran ran =
      run(lab.on(0, {program("gemingad"), "--interface", "lo", "--gcnp", "127.0.0.1:4799", "--gcnp-socket", file}));
  EXPECT_EQ(ran.status, 2);
  EXPECT_THAT(ran.said, HasSubstr("is no socket"));
  EXPECT_EQ(fs::file_size(file), 8U);
}

TEST(OtherProtocols, AreClosedAtTheirFirstOctetsAndNotObeyed) {
  using namespace std::string_literals;
  Lab lab(1);
  lab.start(0);
  const std::string statement = "\r\n1 pub create mode=oto text=evil port=1\r\n0 sys ping\r\n";
  const std::vector<std::string> hellos{
      "\x00\x01\x00\x38\x21\x12\xa4\x42"s + statement,  // STUN
      "\x16\x03\x01\x02\x00"s,                          // TLS
      "\x00\x01\x00\x38\x21\x12\xa4\x42"s,              // STUN, and never a line end
      "POST / HTTP/1.1" + statement,
      "0\x0c\x02\x01\x01"s,  // LDAP begins with the octet of a zero
      "SSH-2.0-x" + statement,
      "\r\n" + statement,  //
      "GET",
      "{\"method\":\"create\"}"  //
  };
  for (const std::string& hello : hellos) {
    Talk stranger = lab.talk(0);
    stranger.send(hello);
    const auto answer = stranger.line();
    ASSERT_TRUE(answer) << testing::PrintToString(hello);
    EXPECT_THAT(*answer, StartsWith("0 400 "));
    EXPECT_TRUE(stranger.is_closed_by_daemon()) << testing::PrintToString(hello);
  }
  Talk user = lab.talk(0);
  EXPECT_THAT(user.query("services"), IsEmpty());
  user.send("\x16\x03\x01 no statement\r\nGET / HTTP/1.1\r\n\r\n");
  EXPECT_THAT(user.lines_until_pong(), SizeIs(3)) << "behind a good line errors cost nothing";
}

TEST(SilentClients, DoNotLockOthersOut) {
  Lab lab(1);
  lab.start(0);
  std::vector<Talk> silent;
  for (int number = 0; number < 150; ++number) silent.push_back(lab.talk(0));
  Talk user = lab.talk(0);
  EXPECT_THAT(user.lines_until_pong(), IsEmpty());
  const auto reason = silent.front().line();
  ASSERT_TRUE(reason);
  EXPECT_THAT(*reason, StartsWith("0 429 closed: "));
}

TEST(GreedyClients, GiveBackWhatAnotherNeeds) {
  Lab lab(1);
  lab.start(0);
  std::vector<Talk> greedy;
  for (int client = 0; client < 4; ++client) {
    greedy.push_back(lab.talk(0));
    for (int number = 1; number <= 256; ++number) {
      greedy.back().say(std::to_string(number) + " pub create mode=oto text=greed port=1");
    }
    EXPECT_THAT(greedy.back().lines_until_pong(), IsEmpty());
  }
  Talk honest = lab.talk(0);
  for (int number = 1; number <= 10; ++number) {
    honest.say(std::to_string(number) + " pub create mode=oto text=honest port=1");
  }
  EXPECT_THAT(honest.lines_until_pong(), IsEmpty());
  EXPECT_THAT(honest.query("services text=honest"), SizeIs(10));
  EXPECT_THAT(greedy.front().lines_until_pong(), Contains(StartsWith("256 429 taken back: ")));
}

TEST(StalledClients, CostAnInnocentOneNothingAndAreBroughtUpToDate) {
  std::string folder = fs::temp_directory_path() / "geminga-stalled-XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const std::string path = folder + "/gcnp";
  Lab lab(1);
  lab.start(0, {"--gcnp-socket", path});
  std::vector<Talk> stalled;  // over the Unix socket, for which the kernel keeps less
  for (int client = 0; client < 6; ++client) {
    stalled.push_back(lab.talk(0, path));
    stalled.back().say("1 sub create mode=otm/stream text=x");
    EXPECT_THAT(stalled.back().lines_until_pong(), IsEmpty());
  }
  Talk provider = lab.talk(0);
  provider.say("1 pub create mode=otm/stream text=x port=1");
  const std::string note(200, 'x');
  std::string last;
  for (int serial = 0; serial < 4000; ++serial) {
    last = std::to_string(serial);
    provider.say("1 pub modify attr.serial=" + last + " attr.first=" + note + " attr.second=" + note);
    if (serial % 500 == 0) {
      EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
    }
  }
  EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
  EXPECT_THAT(lab.talk(0).lines_until_pong(), IsEmpty()) << "an innocent one";
  for (Talk& one : stalled) {
    const auto told = one.lines_until_pong();
    EXPECT_THAT(told, Contains("0 msg lagged"));
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(field(told.back(), "serial"), last) << "how things stand at the end is exact";
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace geminga::system
