// --exec of geminga-publish and geminga-subscribe: one command for each event, into which no peer can write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <boost/json/object.hpp>
#include <csignal>
#include <filesystem>

#include "client/scripted_daemon.hpp"
#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using client::Conversation;
using client::ScriptedDaemon;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string added(int number, const std::string& more = "") {
  return "1 pub add service=5e6f7a8b/2/" + std::to_string(number) +
         " provider=5e6f7a8b/2 name=vision id=7 degree=exact distance=0 mode=otm/stream address=10.0.0.2 port=" +
         std::to_string(5000 + number) + " protocol=udp priority=0 participant_name=robot5" + more;
}

/// A connection on which these lines come as soon as the request is made.
ScriptedDaemon::Script saying(const std::vector<std::string>& lines, bool goes = false) {
  return [lines, goes](Conversation& talk) {
    talk.welcome();
    talk.hear();
    std::string octets;  // in one piece, so that all of it is there when the first command runs
    for (const auto& line : lines) octets += line + "\r\n";
    talk.send(octets);
    talk.expect("0 sys ping");
    talk.say("0 msg pong");
    if (!goes) talk.wait_for_end();
  };
}

std::vector<std::string> words(const ScriptedDaemon& daemon, const std::string& command,
                               const std::vector<std::string>& more = {}) {
  std::vector<std::string> line{
      system::program("geminga-subscribe"), "--id", "7", "--connect", daemon.address(), "--exec", command};
  line.insert(line.end(), more.begin(), more.end());
  return line;
}

std::unique_ptr<Process> start(const ScriptedDaemon& daemon, const std::string& command,
                               const std::vector<std::string>& more = {}) {
  return std::make_unique<Process>(
      Process::Start{.words = words(daemon, command, more), .environment = {}, .before = {}});
}

TEST(Exec, RunsACommandForEachOfManyEventsInTheirOrder) {
  constexpr int count = 300;
  std::vector<std::string> lines;
  std::string expected;
  for (int number = 1; number <= count; ++number) {
    lines.push_back(added(number));
    expected += std::to_string(5000 + number) + '\n';
  }
  ScriptedDaemon daemon({saying(lines)});
  const auto ran = system::run({.words = words(daemon, "echo $GEMINGA_PORT", {"--count", std::to_string(count)}),
                                .environment = {},
                                .before = {}});
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.said, expected);
}

TEST(Exec, GivesTheEventAsVariablesAndAsJson) {
  const Bench bench;
  const auto publish = bench.start("geminga-publish", {"--text", "camera", "--port", "5000", "rate=30", "a.b=1"});
  const std::string command =
      "env | grep ^GEMINGA_ATTRIBUTE; echo $GEMINGA_EVENT $GEMINGA_TEXT $GEMINGA_NAME $GEMINGA_PORT $GEMINGA_MODE "
      "$GEMINGA_PROTOCOL; cat";
  const auto outcome = bench.run("geminga-subscribe", {"--text", "camera", "--count", "1", "--exec", command});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const std::string before = "GEMINGA_ATTRIBUTE_rate=30\nadd camera geminga-publish 5000 otm/stream udp\n";
  ASSERT_THAT(outcome.out, StartsWith(before));
  const auto event = parsed(outcome.out.substr(before.size())).as_object();
  EXPECT_EQ(event.at("event"), "add");
  EXPECT_EQ(event.at("attributes").as_object().at("a.b"), "1") << "no variable can have that name";
  EXPECT_EQ(event.at("port"), 5000);
}

TEST(Exec, TakesNothingFromOthersAsACommand) {
  Bench bench;
  const auto folder = std::filesystem::temp_directory_path() / ("geminga-exec-" + std::to_string(::getpid()));
  const std::string touch = "touch " + folder.string();
  Talk stranger = bench.talk();
  stranger.say("0 sys hello name=$(id)");
  stranger.say("1 pub create mode=otm/stream text=\"`" + touch + "`;" + touch + "\" port=5000 attr.a=\"x\\n" + touch +
               "\\n\" attr.b=\"'; " + touch + " #\" attr.LD_PRELOAD=/nowhere attr.PATH=\"$(" + touch + ")\"");
  EXPECT_TRUE(stranger.line_with({"0 msg hello"}));
  EXPECT_THAT(stranger.lines_until_pong(), testing::IsEmpty());
  const std::string text = "`" + touch + "`;" + touch;
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"(printf '%s|%s|' "$GEMINGA_TEXT" "$GEMINGA_ATTRIBUTE_b"; cat >/dev/null)", text + "|'; " + touch + " #|"},
      {R"(printf '%s|' "$GEMINGA_NAME" "$GEMINGA_ATTRIBUTE_a")", "$(id)|x\n" + touch + "\n|"},
      {"printf '%s|' $GEMINGA_NAME", "$(id)|"},
      {"printenv GEMINGA_ATTRIBUTE_LD_PRELOAD GEMINGA_ATTRIBUTE_PATH; cat >/dev/null", "/nowhere\n$(" + touch + ")\n"},
  };
  for (const auto& [command, printed] : cases) {
    const auto outcome =
        bench.run("geminga-subscribe", {"--text", text, "--count", "1", "--timeout", "30", "--exec", command});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "") << command;
    EXPECT_EQ(outcome.out, printed) << command;
    EXPECT_FALSE(std::filesystem::exists(folder)) << command;
  }
}

TEST(Exec, NamesWhatIsGoneWhole) {
  ScriptedDaemon daemon({saying({added(1, " rate=30"), "1 pub del service=5e6f7a8b/2/1 reason=left"})});
  const auto ran = system::run({.words = words(daemon,
                                               "echo $GEMINGA_EVENT $GEMINGA_REASON $GEMINGA_ADDRESS:$GEMINGA_PORT "
                                               "$GEMINGA_ATTRIBUTE_rate ${GEMINGA_COST-none}",
                                               {"--count", "2"}),
                                .environment = {{"GEMINGA_COST", "of another event"}},
                                .before = {}});
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.said, "add 10.0.0.2:5001 30 none\ndel left 10.0.0.2:5001 30 none\n");
}

TEST(Exec, TellsOfEachCommandThatFailsAndGoesOn) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"exit 7", "exit status 7"},
      {"no-such-program-anywhere", "exit status 127"},
      {"/dev/null", "exit status 126"},
      {"kill -9 $$", "killed by signal 9"},
      {"exec <&- >&- 2>&-; exit 3", "exit status 3"},
  };
  for (const auto& [command, complaint] : cases) {
    ScriptedDaemon daemon({saying({added(1), added(2)})});
    const auto ran = system::run({.words = words(daemon, command, {"--count", "2"}), .environment = {}, .before = {}});
    EXPECT_EQ(ran.status, 0) << command;
    for (const char* event : {"1", "2"}) {
      EXPECT_THAT(ran.said, HasSubstr("geminga-subscribe: --exec: " + complaint + " (add 5e6f7a8b/2/" + event + ")\n"));
    }
  }
}

TEST(Exec, EndsACommandThatRunsTooLongWithAllThatItStarted) {
  ScriptedDaemon daemon({saying({added(1), added(2)})});
  const auto ran = system::run({.words = words(daemon, "sleep 1000 | cat", {"--count", "2", "--exec-timeout", "0.05"}),
                                .environment = {},
                                .before = {}});
  EXPECT_EQ(ran.status, 0);
  for (const char* event : {"1", "2"}) {  // standard output ends only when no process holds it
    EXPECT_THAT(ran.said, HasSubstr(std::string("ended after 0.05 s, see --exec-timeout (add 5e6f7a8b/2/") + event));
  }
}

TEST(Exec, KillsACommandThatDoesNotEndWhenItIsTold) {
  ScriptedDaemon daemon({saying({added(1)})});
  const auto ran = system::run(
      {.words = words(daemon, "trap '' TERM; sleep 1000; sleep 1000", {"--count", "1", "--exec-timeout", "0.3"}),
       .environment = {},
       .before = {}});
  EXPECT_EQ(ran.status, 0);
  EXPECT_THAT(ran.said, HasSubstr("ended after 0.3 s"));
}

TEST(Exec, PassesASignalOnAndEnds) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    ScriptedDaemon daemon({saying({added(1), added(2)})});
    const std::string name = signal == SIGINT ? "INT" : signal == SIGTERM ? "TERM" : "HUP";
    auto subscribe = start(daemon, "trap 'echo was told; exit 3' " + name + "; sleep 1000 & echo running; wait");
    ASSERT_TRUE(subscribe->wait_for("running\n")) << subscribe->said();
    subscribe->signal(signal);
    EXPECT_EQ(subscribe->wait(), 0) << name;
    EXPECT_THAT(subscribe->said(), HasSubstr("was told\n"));
    EXPECT_THAT(subscribe->said(), HasSubstr("--exec: not run any more, for so many events that waited: 1\n"));
    EXPECT_THAT(subscribe->said(), Not(HasSubstr("exit status"))) << "it ended as it was told";
  }
}

TEST(Exec, EndsWithTheTimeAlsoWhereACommandNeverDoes) {
  const auto status_after = [](const std::vector<std::string>& more) {
    ScriptedDaemon daemon({saying({added(1)})});
    return system::run({.words = words(daemon, "sleep 1000", more), .environment = {}, .before = {}}).status;
  };
  EXPECT_EQ(status_after({"--timeout", "0.2", "--count", "1"}), 4);
  EXPECT_EQ(status_after({"--timeout", "0.2", "--count", "2"}), 4);
  int status = 4;  // a busy machine needs longer until the event is there
  for (int seconds = 1; status == 4 && seconds < 60; seconds *= 3) {
    status = status_after({"--timeout", std::to_string(seconds)});
  }
  EXPECT_EQ(status, 0) << "something was told";
}

TEST(Exec, RunsWhatHasComeWhenTheDaemonGoes) {
  ScriptedDaemon daemon({saying({added(1), added(2), added(3)}, true)});
  const auto ran = system::run({.words = words(daemon, "echo $GEMINGA_PORT"), .environment = {}, .before = {}});
  EXPECT_EQ(ran.status, 3);
  EXPECT_THAT(ran.said, HasSubstr("5003\n"));
}

TEST(Exec, TellsWhatADaemonThatReturnsDoesNotConfirm) {
  ScriptedDaemon daemon({saying({added(1), added(2)}, true), saying({added(2)})});
  const auto ran = system::run(
      {.words = words(daemon, "echo $GEMINGA_EVENT $GEMINGA_PORT $GEMINGA_REASON", {"--keep", "--count", "4"}),
       .environment = {},
       .before = {}});
  EXPECT_EQ(ran.status, 0) << ran.said;
  EXPECT_THAT(ran.said, EndsWith("add 5002\ndel 5001 unconfirmed\n"));
}

TEST(Exec, KeepsWhatIsAskedForUntilTheLastCommandHasEnded) {
  Bench bench;
  const auto publish = bench.start("geminga-publish", {"--text", "camera", "--mode", "oto", "--port", "5000"});
  const auto outcome = bench.run("geminga-subscribe", {"--text", "camera", "--mode", "oto", "--count", "1", "--exec",
                                                       system::program("geminga-query") + " requests camera"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.out, HasSubstr("geminga-subscribe@")) << outcome.errors;
}

TEST(Exec, OfAPublicationRunsForItsConsumers) {
  Bench bench;
  auto publish = bench.start("geminga-publish", {"--text", "lamp", "--mode", "oto", "--port", "5000", "--exec",
                                                 "echo $GEMINGA_EVENT $GEMINGA_NAME by $GEMINGA_REASON."});
  ASSERT_TRUE(publish->wait_for("offering")) << publish->said();
  {
    Talk consumer = bench.talk();
    consumer.say("0 sys hello name=world");
    consumer.say("1 sub create mode=oto text=lamp");
    EXPECT_TRUE(publish->wait_for("add world by .")) << publish->said();
  }
  EXPECT_TRUE(publish->wait_for("del world by ")) << publish->said();
  publish->signal(SIGTERM);
  EXPECT_EQ(publish->wait(), 0);
}

TEST(Exec, LeavesACommandNothingOfTheProgramButItsOutput) {
  ScriptedDaemon daemon({saying({added(1)})});
  const auto ran = system::run({.words = words(daemon,
                                               "cd /proc/self/fd && echo *; grep ^SigBlk "
                                               "/proc/self/status",
                                               {"--count", "1"}),
                                .environment = {},
                                .before = {}});
  EXPECT_EQ(ran.status, 0);
  EXPECT_THAT(ran.said, StartsWith("0 1 2 3\n")) << "3 is how it looks";
  EXPECT_THAT(ran.said, HasSubstr("SigBlk:\t0000000000000000\n"));
}

TEST(Exec, TellsTheCommandWhichDaemonItIs) {
  ScriptedDaemon daemon({saying({added(1)})});
  const auto ran = system::run({.words = words(daemon, "echo $GEMINGA_CONNECT", {"--count", "1"}),
                                .environment = {{"GEMINGA_CONNECT", "127.0.0.1:1"}},
                                .before = {}});
  EXPECT_EQ(ran.said, daemon.address() + "\n") << "--connect is stronger";
}

TEST(Exec, RefusesWhatWouldMeanNothingBesideIt) {
  const Bench bench;
  const std::vector<std::vector<std::string>> cases{
      {"geminga-subscribe", "--text", "x", "--exec", "true", "--json"},
      {"geminga-subscribe", "--text", "x", "--exec", "true", "--timestamps"},
      {"geminga-subscribe", "--text", "x", "--exec", "true", "--listen"},
      {"geminga-subscribe", "--text", "x", "--exec", ""},
      {"geminga-subscribe", "--text", "x", "--exec"},
      {"geminga-subscribe", "--text", "x", "--exec-timeout", "5"},
      {"geminga-subscribe", "--text", "x", "--exec", "true", "--exec-timeout", "soon"},
      {"geminga-publish", "--text", "x", "--exec", "true", "--send"},
      {"geminga-publish", "--text", "x", "--port", "1", "--exec", "true", "--json"},
  };
  for (const auto& line : cases) {
    const auto outcome = bench.run(line.front(), {line.begin() + 1, line.end()});
    EXPECT_EQ(outcome.status, 2) << testing::PrintToString(line);
    EXPECT_THAT(outcome.errors, StartsWith(line.front() + ": ")) << testing::PrintToString(line);
  }
}

}  // namespace
}  // namespace geminga::tools
