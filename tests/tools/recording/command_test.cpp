// geminga-query record and replay on a real daemon, as a user runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <thread>

#include "system/folder.hpp"
#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Waits until a file contains a text; false where patience ends.
bool wait_for(const std::string& path, const std::string& text) {
  const int changes = ::inotify_init1(IN_CLOEXEC);
  const std::string folder = std::filesystem::path(path).parent_path();
  EXPECT_GE(::inotify_add_watch(changes, folder.c_str(), IN_MODIFY | IN_CREATE), 0);
  const auto end = std::chrono::steady_clock::now() + system::patience;
  bool is_there = false;
  while (!(is_there = text_of(path).contains(text)) && std::chrono::steady_clock::now() < end) {
    pollfd change{.fd = changes, .events = POLLIN, .revents = 0};
    std::array<char, 4096> events{};
    if (::poll(&change, 1, 1000) == 1 && ::read(changes, events.data(), events.size()) < 0) break;
  }
  ::close(changes);
  return is_there;
}

class RecordAndReplay : public testing::Test {
 protected:
  [[nodiscard]] std::string in(const char* name) const { return folder_.path(name); }

  /// Records a service that comes and goes, and a request that nobody serves.
  void record(const std::string& file) {
    auto recorder = bench_.start("geminga-query", {"record", file});
    ASSERT_TRUE(wait_for(file, "\"event\":\"heard\"")) << recorder->said();
    Talk peer = bench_.talk();
    peer.say("0 sys hello name=vision");
    peer.say("1 pub create mode=oto concept=soccer:BallInfo port=5000 rate=30");
    peer.say("2 sub create mode=oto text=nobody");
    peer.say("3 sub create mode=oto concept=soccer:TrackedObject");
    ASSERT_TRUE(wait_for(file, "soccer:BallInfo")) << recorder->said();
    ASSERT_TRUE(wait_for(file, "\"kind\":\"why\"")) << recorder->said();
    ASSERT_TRUE(wait_for(file, "\"kind\":\"match\"")) << recorder->said();
    peer.say("1 pub remove");
    ASSERT_TRUE(wait_for(file, "\"event\":\"del\"")) << recorder->said();
    recorder->signal(SIGINT);
    EXPECT_EQ(recorder->wait(), 0);
    EXPECT_THAT(recorder->said(), HasSubstr("geminga-query: recorded "));
    EXPECT_THAT(text_of(file), HasSubstr("\"reason\":\"stopped\"}\n"));
  }

  /// Runs geminga-query against the replay.
  Outcome ask(std::vector<std::string> words) {
    words.insert(words.begin(), {"--connect", in("replay.sock")});
    return bench_.query(words);
  }
  std::unique_ptr<Process> play(std::vector<std::string> words) {
    words.insert(words.begin(), {"replay", "--gcnp", in("replay.sock")});
    auto player = bench_.start("geminga-query", words);
    EXPECT_TRUE(player->wait_for(" participants\n")) << player->said();
    return player;
  }
  /// The second of the recording in which the first such line was written, in words, a thousandth later.
  static std::string moment_of(const std::string& file, const std::string& what) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
      if (line.contains(what)) return std::to_string(parsed(line).at("at").to_number<double>() + 0.001).substr(0, 7);
    }
    ADD_FAILURE() << "no line has " << what;
    return "0";
  }

  Bench bench_;
  system::Folder folder_;
};

TEST_F(RecordAndReplay, ShowYesterdaysTeamToTheToolsOfToday) {
  const std::string file = in("team.jsonl");
  record(file);
  bench_.stop_daemon();
  auto player = play({file, "--at", moment_of(file, "\"kind\":\"why\"")});
  const auto services = parsed(ask({"--json", "services"}).out);
  ASSERT_EQ(services.as_array().size(), 1U);
  EXPECT_EQ(services.at(0).at("concept"), "soccer:BallInfo");
  EXPECT_EQ(services.at(0).at("attributes").at("rate"), "30");
  EXPECT_EQ(services.at(0).at("port"), 5000);
  EXPECT_THAT(ask({"participants"}).out, HasSubstr("(this host)"));
  EXPECT_THAT(ask({"requests", "--unmatched"}).out, HasSubstr("nobody offers text=nobody"));
  const std::string request(parsed(ask({"--json", "requests"}).out).at(0).at("subscription").as_string());
  EXPECT_THAT(ask({"why", request}).out, HasSubstr("nobody offers text=nobody"));
  player->signal(SIGTERM);
  EXPECT_EQ(player->wait(), 0);
  player = play({file, "--at", moment_of(file, "\"kind\":\"match\"")});
  const auto matched = parsed(ask({"--json", "match", "soccer:TrackedObject"}).out);
  EXPECT_EQ(matched.at(0).at("concept"), "soccer:BallInfo") << "by the ontology of that day";
  EXPECT_EQ(matched.at(0).at("degree"), "narrower");
  EXPECT_EQ(ask({"status"}).status, 0);
  EXPECT_EQ(ask({"ontology"}).status, 0);
  EXPECT_EQ(ask({"security"}).status, 0);
  const Outcome explained = ask({"explain", "soccer:BallInfo", "soccer:TrackedObject"});
  EXPECT_EQ(explained.status, 2);
  EXPECT_THAT(explained.errors, HasSubstr("a recording has no ontology"));
  player->signal(SIGTERM);
  EXPECT_EQ(player->wait(), 0);
  EXPECT_FALSE(std::filesystem::exists(in("replay.sock")));
}

TEST_F(RecordAndReplay, StreamEventsToAWatcherAndStayAtTheEnd) {
  const std::string file = in("team.jsonl");
  record(file);
  auto player = play({file, "--speed", "2"});
  auto watch = bench_.start("geminga-query", {"--connect", in("replay.sock"), "--watch", "services"});
  EXPECT_TRUE(watch->wait_for("+ vision@robot0  soccer:BallInfo")) << watch->said();
  EXPECT_TRUE(watch->wait_for("- vision@robot0  soccer:BallInfo")) << watch->said();
  EXPECT_TRUE(player->wait_for("The recording ends at ")) << player->said();
  EXPECT_EQ(ask({"participants"}).status, 0);
  player->signal(SIGTERM);
  EXPECT_EQ(player->wait(), 0);
  EXPECT_EQ(watch->wait(), 3);
}

TEST_F(RecordAndReplay, EndWithTheRecordingWhereTold) {
  const Outcome outcome = bench_.query({"replay", GEMINGA_SOURCE_DIR "/tests/fuzz/seeds/recording/field_test.jsonl",
                                        "--gcnp", in("replay.sock"), "--speed", "10000", "--end"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.out, HasSubstr("The recording ends at 2026-11-27T03:10:12.319Z.\n"));
}

TEST_F(RecordAndReplay, AnswerEverythingToAClientThatReadsLate) {
  auto player = play({GEMINGA_SOURCE_DIR "/tests/fuzz/seeds/recording/field_test.jsonl", "--at", "5"});
  const int client = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  in("replay.sock").copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  // The answers are more than may wait for a client (env::max_queued_bytes), so the replay has to wait for it.
  constexpr int questions = 50'000;
  std::string said;
  for (int i = 1; i <= questions; ++i) said += std::to_string(i) + " query services\n";
  // It says all that the replay takes while nobody reads, and the rest while it reads.
  std::string_view left = said;
  const auto say = [&](int flags) {
    while (!left.empty()) {
      const ssize_t size = ::send(client, left.data(), left.size(), MSG_NOSIGNAL | flags);
      if (size <= 0) return;
      left.remove_prefix(static_cast<std::size_t>(size));
    }
  };
  say(MSG_DONTWAIT);
  std::thread speaker([&] {
    say(0);
    ::shutdown(client, SHUT_WR);
  });
  std::string heard;
  std::array<char, 65'536> chunk{};
  for (ssize_t size = 0; (size = ::read(client, chunk.data(), chunk.size())) > 0;) {
    heard.append(chunk.data(), static_cast<std::size_t>(size));
  }
  speaker.join();
  ::close(client);
  EXPECT_GT(heard.size(), std::size_t{8} * 1024 * 1024);
  EXPECT_THAT(heard, testing::EndsWith("\r\n" + std::to_string(questions) + " msg end count=1\r\n"));
  player->signal(SIGTERM);
  EXPECT_EQ(player->wait(), 0);
}

TEST_F(RecordAndReplay, RefuseStatementsOfPrograms) {
  const std::string file = in("team.jsonl");
  record(file);
  auto player = play({file, "--at", "0"});
  const Outcome offered =
      bench_.run("geminga-publish", {"--connect", in("replay.sock"), "--text", "x", "--port", "5", "--mode", "oto"});
  EXPECT_EQ(offered.status, 2);
  EXPECT_THAT(offered.errors, HasSubstr("this is a recording"));
  player->signal(SIGTERM);
  EXPECT_EQ(player->wait(), 0);
}

TEST_F(RecordAndReplay, IsMovedByWordsOnStandardInput) {
  const std::string words = in("words");
  ASSERT_EQ(::mkfifo(words.c_str(), 0600), 0);
  const std::string file = GEMINGA_SOURCE_DIR "/tests/fuzz/seeds/recording/field_test.jsonl";
  auto player = bench_.start("/bin/sh", {"-c", "exec \"$0\" replay \"$1\" --gcnp \"$2\" <\"$3\"",
                                         system::program("geminga-query"), file, in("replay.sock"), words});
  std::ofstream user(words);
  user << "seek 3\npause\n" << std::flush;
  ASSERT_TRUE(player->wait_for("Stands at 2026-11-27T03:10:05")) << player->said();
  user << "faster\nspeed 0.5\n" << std::flush;
  ASSERT_TRUE(player->wait_for("'faster' is no word for a replay")) << player->said();
  ASSERT_TRUE(player->wait_for(", speed 0.5")) << player->said();
  user << "-3\n" << std::flush;
  ASSERT_TRUE(player->wait_for("Stands at 2026-11-27T03:10:02")) << player->said();
  user.close();
  EXPECT_EQ(ask({"participants"}).status, 0) << "it goes on without a user";
  player->signal(SIGTERM);
  EXPECT_EQ(player->wait(), 0);
}

TEST_F(RecordAndReplay, GoOnWhenTheDaemonIsThereAgain) {
  const std::string file = in("team.jsonl");
  auto recorder = bench_.start("geminga-query", {"record", file});
  ASSERT_TRUE(wait_for(file, "\"event\":\"heard\"")) << recorder->said();
  bench_.stop_daemon();
  ASSERT_TRUE(wait_for(file, "\"event\":\"lost\"")) << recorder->said();
  EXPECT_TRUE(recorder->wait_for("the recording goes on when it is there again"));
  bench_.start_daemon();
  EXPECT_TRUE(recorder->wait_for("the daemon is there again"));
  ASSERT_TRUE(wait_for(file, "\"event\":\"snapshot\""));
  recorder->signal(SIGTERM);
  EXPECT_EQ(recorder->wait(), 0);
}

TEST_F(RecordAndReplay, KeepAFileThatIsThereUnlessToldToAppend) {
  const std::string file = in("team.jsonl");
  std::ofstream(file) << R"({"event":"sna)";  // cut by a loss of power
  const Outcome refused = bench_.query({"record", file});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.errors, HasSubstr("is there already"));
  auto recorder = bench_.start("geminga-query", {"record", file, "--append"});
  ASSERT_TRUE(wait_for(file, "\"event\":\"heard\"")) << recorder->said();
  recorder->signal(SIGTERM);
  EXPECT_EQ(recorder->wait(), 0);
  auto player = play({file, "--at", "0"});
  EXPECT_THAT(player->said(), HasSubstr("line 1, octet 0: is no JSON object"));
  EXPECT_EQ(ask({"participants"}).status, 0);
}

TEST_F(RecordAndReplay, SayWhatIsWrongOnTheCommandLine) {
  const std::string file = in("garbage");
  std::ofstream(file) << "not\na\nrecording\n";
  EXPECT_EQ(bench_.query({"replay", in("missing")}).status, 2);
  const Outcome garbage = bench_.query({"replay", file});
  EXPECT_EQ(garbage.status, 2);
  EXPECT_THAT(garbage.errors, HasSubstr("line 3, octet 6: is no JSON object"));
  EXPECT_THAT(garbage.errors, HasSubstr("is no recording"));
  EXPECT_THAT(garbage.out, IsEmpty());
  std::ofstream(in("many")) << std::string(1000, '\n');
  EXPECT_THAT(bench_.query({"replay", in("many")}).errors, HasSubstr(": 980 more such lines"));
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--speed", "0"},
                                                {"--speed", "nan"},
                                                {"--from", "noon"},
                                                {"--at", "1", "--from", "2"},
                                                {"--gcnp", "robot:4717"},
                                                {"--watch"}}) {
    std::vector<std::string> line{"replay", GEMINGA_SOURCE_DIR "/tests/fuzz/seeds/recording/field_test.jsonl"};
    line.insert(line.end(), words.begin(), words.end());
    EXPECT_EQ(bench_.query(line).status, 2) << words[0];
  }
  for (const char* limit : {"0", "65537", "-1", "much"}) {
    EXPECT_EQ(bench_.query({"record", in("x"), "--limit", limit}).status, 2) << limit;
  }
  EXPECT_EQ(bench_.query({"record", in("no/folder")}).status, 2);
  EXPECT_EQ(bench_.query({"--connect", nobody(), "record", in("y")}).status, 3);
  EXPECT_FALSE(std::filesystem::exists(in("y")));
}

TEST_F(RecordAndReplay, SayThatTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const Outcome outcome = bench_.query({"record", "--append", "/dev/full"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("/dev/full cannot be written: No space left on device"));
}

}  // namespace
}  // namespace geminga::tools
